// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/parallel.h"

#ifdef PCL_OPS_STANDARD_THREADS
#include "base/standard_threads.h"
#endif

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <cstdint>
#include <exception>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace pcl_ops::internal {

namespace {

#ifdef _OPENMP
/** \brief How many threads the system starts at a time, this one included. */
int
startableThreads (int wanted)
{
  std::vector<std::thread> threads;
  std::promise<void> all_tried;
  const std::shared_future<void> end = all_tried.get_future().share();
  try {
    threads.reserve (static_cast<std::size_t> (wanted));
    while (static_cast<int> (threads.size()) + 1 < wanted)
      threads.emplace_back ([end] { end.wait(); });
  }
  catch (const std::exception&) {
    // As many as there are will do.
  }
  all_tried.set_value();
  for (std::thread& thread : threads)
    thread.join();
  return static_cast<int> (threads.size()) + 1;
}

/** \brief No more than can be started: where OpenMP's runtime cannot start a thread, it
 * ends the program. */
int
safeThreads (int wanted)
{
  // OpenMP keeps the threads it has started, for each thread that asked for them.
  thread_local int started = 1;
  if (wanted > started)
    started = startableThreads (wanted);
  return std::min (wanted, started);
}

int
usefulThreads (unsigned wanted, std::int64_t pieces)
{
  // More than these only cost.
  constexpr std::int64_t most = 256;
  const std::int64_t threads = wanted ? wanted : omp_get_num_procs();
  return safeThreads (static_cast<int> (
      std::max<std::int64_t> (1, std::min ({threads, pieces, most}))));
}
#endif

} // namespace

namespace {

/** \brief Calls work with each piece; it must not throw. */
template <typename Work>
void
forPieces (unsigned threads, std::int64_t pieces, const Work& work)
{
#ifdef PCL_OPS_STANDARD_THREADS
  forPiecesByStandardThreads (threads, pieces, work);
#else
#ifdef _OPENMP
  const int used = usefulThreads (threads, pieces);
#pragma omp parallel for schedule(dynamic) num_threads(used) if (used > 1)
#else
  (void)threads;
#endif
  for (std::int64_t piece = 0; piece < pieces; ++piece)
    work (piece);
#endif
}

} // namespace

void
parallelFor (unsigned threads,
             std::size_t size,
             std::size_t grain,
             const std::function<void (std::size_t, std::size_t)>& body)
{
  const auto pieces = static_cast<std::int64_t> ((size + grain - 1) / grain);
  // An exception must not leave a thread: it waits for the end of all pieces.
  std::exception_ptr thrown;
  std::mutex guard;
  forPieces (threads, pieces, [&] (std::int64_t piece) {
    const std::size_t begin = static_cast<std::size_t> (piece) * grain;
    try {
      body (begin, std::min (size, begin + grain));
    }
    catch (...) {
      const std::lock_guard<std::mutex> lock (guard);
      thrown = std::current_exception();
    }
  });
  if (thrown)
    std::rethrow_exception (thrown);
}

} // namespace pcl_ops::internal

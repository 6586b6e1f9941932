// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/parallel.h"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>

#ifdef __linux__
#include <sched.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <pthread.h>
#endif

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace pcl_ops::internal {
namespace {

/** \brief The worker threads and the queue of tasks posted to them. */
struct Workers {
  boost::asio::io_context tasks;
  /** \brief Keeps io_context::run_one waiting while there is no task. */
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_guard{
      tasks.get_executor()};
  std::mutex mutex;
  std::size_t started = 0; // number of worker threads; guarded by the mutex

  // Runs tasks forever, as one of the worker threads. Polls for a while before it
  // sleeps: the next task of a detector mostly comes sooner than a sleeping thread
  // wakes up.
  void
  serve ()
  {
    constexpr int polls_before_sleep = 200; // chosen by hand, changes only the time
    while (true) {
      for (int idle_polls = 0; idle_polls < polls_before_sleep; ++idle_polls) {
        if (tasks.poll_one() != 0)
          idle_polls = 0;
        std::this_thread::yield();
      }
      tasks.run_one();
    }
  }
};

using PieceBody = std::function<void (std::size_t, std::size_t)>;

std::size_t
numberOfPieces (std::size_t size, std::size_t piece_size)
{
  return (size + piece_size - 1) / piece_size;
}

/** \brief The pieces of one call of parallelFor, each done by one of its threads. */
class Pieces {
public:
  /** \param[in] body must live until all pieces are done */
  Pieces (std::size_t size, std::size_t piece_size, const PieceBody& body)
  : size_ (size)
  , piece_size_ (piece_size)
  , count_ (numberOfPieces (size, piece_size))
  , body_ (body)
  , is_taken_ (count_)
  {}

  /** \brief Does pieces that no other thread has taken, from piece \p first on, and
   * after the last piece from 0 on. Threads begin at different pieces, so that they
   * seldom compete for one. The calling thread begins at 0 in each loop, so that the
   * data of the loop before may still be in its cache. */
  void
  doPieces (std::size_t first = 0)
  {
    for (std::size_t i = 0; i < count_ && done_ < count_; ++i) {
      const std::size_t piece = (first + i) % count_;
      if (!is_taken_[piece].exchange (true))
        doPiece (piece);
    }
  }

  /** \brief Calls \ref doPieces with a first piece of its own. Workers call this
   * function \p helpers times at most, beside the thread that called parallelFor, which
   * begins at piece 0: the first pieces of all calls are evenly spread. */
  void
  help (std::size_t helpers)
  {
    doPieces (count_ * ++started_helpers_ / (helpers + 1));
  }

  /** \brief Waits until all pieces are done. Rethrows an exception of a piece: the last
   * one if there are several. */
  void
  waitForOthers ()
  {
    std::unique_lock<std::mutex> lock (mutex_);
    all_done_.wait (lock, [this] { return done_ == count_; });
    if (thrown_)
      std::rethrow_exception (thrown_);
  }

private:
  void
  doPiece (std::size_t piece)
  {
    try {
      body_ (piece * piece_size_, std::min (size_, (piece + 1) * piece_size_));
    }
    catch (...) {
      const std::lock_guard<std::mutex> lock (mutex_);
      thrown_ = std::current_exception();
    }
    if (++done_ == count_) {
      const std::lock_guard<std::mutex> lock (mutex_);
      all_done_.notify_one();
    }
  }

  std::size_t size_, piece_size_; // in items of the range
  std::size_t count_;             // number of pieces
  const PieceBody& body_;
  std::vector<std::atomic<bool>> is_taken_; // for each piece
  std::atomic<std::size_t> started_helpers_{0};
  std::atomic<std::size_t> done_{0}; // number of pieces done
  std::mutex mutex_;                 // guards thrown_, and the wait for all_done_
  std::condition_variable all_done_;
  std::exception_ptr thrown_; // by a piece; the last one
};

} // namespace

std::size_t
availableProcessors ()
{
#ifdef __linux__
  // The processors that this process may use: taskset and containers limit them.
  cpu_set_t processors;
  if (sched_getaffinity (0, sizeof (processors), &processors) == 0)
    return static_cast<std::size_t> (CPU_COUNT (&processors));
#endif
  return std::max (1u, std::thread::hardware_concurrency());
}

namespace {

/** \brief Returns the workers of this process. They are never destroyed: the threads
 * end with the process. A forked process gets new workers: it has none of the threads
 * of its parent, and its copy of the mutex may be locked. */
Workers&
workersOfThisProcess ()
{
  static Workers* workers = new Workers;
#if defined(__unix__) || defined(__APPLE__)
  static const int registered =
      ::pthread_atfork (nullptr, nullptr, [] { workers = new Workers; });
  static_cast<void> (registered);
#endif
  return *workers;
}

} // namespace

void
callOnWorkers (std::size_t calls, const std::function<void()>& task)
{
  Workers& workers = workersOfThisProcess();
  // At most one call per worker: if the system started no worker at all, posted calls
  // would stay in the queue for ever.
  std::size_t posted = 0;
  {
    const std::lock_guard<std::mutex> lock (workers.mutex);
    try {
      for (; workers.started < calls; ++workers.started)
        std::thread ([&workers] { workers.serve(); }).detach();
    }
    catch (const std::system_error&) {
      // The system starts no more threads: go on with the started ones.
    }
    posted = std::min (calls, workers.started);
  }
  for (std::size_t i = 0; i < posted; ++i)
    boost::asio::post (workers.tasks, task);
}

void
parallelFor (unsigned threads,
             std::size_t size,
             std::size_t piece_size,
             const PieceBody& body)
{
  if (size == 0)
    return;
  // Shared ownership: a helper may start after all pieces are done and this call has
  // returned. So the call waits only for helpers that have begun a piece.
  const auto pieces = std::make_shared<Pieces> (size, piece_size, body);
  constexpr std::size_t max_threads = 256; // chosen by hand, however many are asked for
  const std::size_t wanted_threads = threads ? threads : availableProcessors();
  // The calling thread does pieces, too.
  const std::size_t helpers =
      std::min ({wanted_threads, numberOfPieces (size, piece_size), max_threads}) - 1;
  try {
    if (helpers > 0)
      callOnWorkers (helpers, [=] { pieces->help (helpers); });
  }
  catch (const std::bad_alloc&) {
    // Fewer helpers or none: this thread does the pieces that are left. It has to wait
    // for the helpers that began, as they use body.
  }
  pieces->doPieces();
  pieces->waitForOthers();
}

} // namespace pcl_ops::internal

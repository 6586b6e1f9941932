// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "base/parallel.h"
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <climits>
#include <future>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

using namespace pcl_ops::internal;

namespace {

#ifndef __has_feature // of Clang
#define __has_feature(name) 0
#endif
#if defined(__SANITIZE_THREAD__) || __has_feature(thread_sanitizer)
constexpr bool has_thread_sanitizer = true;
#else
constexpr bool has_thread_sanitizer = false;
#endif

/** \brief The first item of a piece and the item after its last one. */
using Piece = std::pair<std::size_t, std::size_t>;

/** \brief The pieces that parallelFor makes of \p size items, in ascending order.
 * \param[in] piece_size items per piece */
std::vector<Piece>
piecesOf (unsigned threads, std::size_t size, std::size_t piece_size)
{
  std::vector<Piece> pieces (size); // at most one for each item
  std::atomic<std::size_t> calls{0};
  parallelFor (threads, size, piece_size, [&] (std::size_t begin, std::size_t end) {
    pieces[calls++] = {begin, end};
  });
  pieces.resize (calls);
  std::sort (pieces.begin(), pieces.end());
  return pieces;
}

} // namespace

TEST (ParallelFor, CoversEveryItemOnce)
{
  constexpr std::size_t piece_size = 4;
  const std::vector<Piece> expected{{0, 4}, {4, 8}, {8, 10}};
  for (const unsigned threads : {0u, 1u, 2u, 4u})
    EXPECT_EQ (piecesOf (threads, 10, piece_size), expected) << threads << " threads";
  EXPECT_TRUE (piecesOf (2, 0, piece_size).empty()) << "of no items";
}

TEST (ParallelFor, RunsOnAllThreadsAtOnceIfTheyAreFree)
{
  constexpr unsigned threads = 6; // more than the test before, so that some start
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds (30);
  std::atomic<unsigned> arrived{0}, threads_that_met_all{0};
  parallelFor (threads, threads, 1, [&] (std::size_t, std::size_t) {
    ++arrived;
    // No thread leaves before all threads have arrived.
    while (arrived < threads && std::chrono::steady_clock::now() < deadline)
      std::this_thread::yield();
    threads_that_met_all += arrived == threads;
  });
  EXPECT_EQ (threads_that_met_all, threads);
}

TEST (ParallelFor, HasThreadsOfItsOwnInAProcessThatIsForkedOff)
{
  if (has_thread_sanitizer)
    GTEST_SKIP() << "the sanitizer ends a forked process that starts threads";
  // Starts threads in this process, which its child does not have.
  const unsigned threads = 2;
  parallelFor (threads, 2, 1, [] (std::size_t, std::size_t) {});
  const pid_t child = fork();
  if (child == 0) {
    std::atomic<int> arrived{0};
    std::promise<void> both_arrived;
    const std::shared_future<void> meeting = both_arrived.get_future().share();
    parallelFor (threads, 2, 1, [&] (std::size_t, std::size_t) {
      if (++arrived == 2)
        both_arrived.set_value();
      meeting.wait_for (std::chrono::seconds (20)); // for the other thread
    });
    const bool have_met =
        meeting.wait_for (std::chrono::seconds (0)) == std::future_status::ready;
    _exit (have_met && arrived == 2 ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ (waitpid (child, &status, 0), child);
  EXPECT_EQ (status, 0);
}

TEST (ParallelFor, TakesMoreThreadsThanAMachineHas)
{
  EXPECT_EQ (piecesOf (UINT_MAX, 1000, 1).size(), 1000u);
  EXPECT_EQ (piecesOf (1000000, 10000, 1).size(), 10000u);
}

TEST (ParallelFor, DoesNotWaitForThreadsThatAreBusy)
{
  // All workers wait until the test is over, as on a machine with other programs.
  // parallelFor has 256 threads at most, so that no test before started more workers.
  constexpr std::size_t all_workers = 256;
  std::promise<void> all_done;
  const std::shared_future<void> end_of_test = all_done.get_future().share();
  callOnWorkers (all_workers, [end_of_test] { end_of_test.wait(); });
  EXPECT_EQ (piecesOf (4, 1000, 1).size(), 1000u);
  all_done.set_value();
}

TEST (ParallelFor, RethrowsWhatItsBodyThrows)
{
  // Pieces of one item.
  const auto body = [] (std::size_t begin, std::size_t) {
    if (begin == 50)
      throw std::runtime_error ("piece 50");
  };
  for (const unsigned threads : {1u, 2u})
    EXPECT_THROW (parallelFor (threads, 100, 1, body), std::runtime_error);
}

TEST (ParallelPieces, ReturnResultsInTheOrderOfThePiecesForAnyNumberOfThreads)
{
  for (const unsigned threads : {1u, 2u, 8u}) {
    const auto ends = parallelPieces (
        threads, 10, 4, [] (std::size_t, std::size_t end) { return end; });
    EXPECT_EQ (ends, (std::vector<std::size_t>{4, 8, 10}));
  }
}

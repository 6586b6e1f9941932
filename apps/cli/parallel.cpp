// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace pcl_ops::apps {

void
runInParallel (std::size_t count,
               unsigned jobs,
               const std::function<void (std::size_t)>& work)
{
  std::atomic<std::size_t> next{0};
  std::atomic<bool> has_failed{false};
  std::exception_ptr failure;
  const auto take_turns = [&] {
    try {
      for (std::size_t i; !has_failed && (i = next++) < count;)
        work (i);
    }
    catch (...) {
      if (!has_failed.exchange (true))
        failure = std::current_exception();
    }
  };
  const unsigned wanted = jobs == 0 ? std::thread::hardware_concurrency() : jobs;
  std::vector<std::thread> threads;
  try {
    for (std::size_t i = 1; i < std::min<std::size_t> (wanted, count); ++i)
      threads.emplace_back (take_turns);
  }
  catch (const std::exception&) {
    // No memory or no right for one more: those there are do the work, this one at
    // least.
  }
  take_turns();
  for (std::thread& thread : threads)
    thread.join();
  if (failure)
    std::rethrow_exception (failure);
}

} // namespace pcl_ops::apps

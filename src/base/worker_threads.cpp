// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/worker_threads.h"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <mutex>
#include <system_error>
#include <thread>

namespace pcl_ops::internal {

namespace {

class Workers {
public:
  /** \brief Never destroyed: the threads end with the process. To wait for them would
   * be in vain in a process that is the copy of another one, which has none of its
   * threads.
   */
  static Workers&
  ofTheProcess ()
  {
    static Workers& workers = *new Workers;
    return workers;
  }

  void
  call (std::size_t number, const std::function<void()>& task)
  {
    startUpTo (number);
    for (std::size_t i = 0; i < number; ++i)
      boost::asio::post (tasks_, task);
  }

private:
  void
  startUpTo (std::size_t number)
  {
    const std::lock_guard<std::mutex> lock (guard_);
    try {
      for (; started_ < number; ++started_)
        std::thread ([this] { serve(); }).detach();
    }
    catch (const std::system_error&) {
      // As many as there are will do.
    }
  }

  // The next task of a detector mostly comes at once: sooner than a thread wakes up.
  void
  serve ()
  {
    constexpr int patience = 200;
    while (true) {
      for (int idle = 0; idle < patience; ++idle) {
        if (tasks_.poll_one() != 0)
          idle = 0;
        std::this_thread::yield();
      }
      tasks_.run_one();
    }
  }

  boost::asio::io_context tasks_;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type>
      more_to_come_{tasks_.get_executor()};
  std::mutex guard_;
  std::size_t started_ = 0;
};

} // namespace

std::size_t
availableProcessors ()
{
#ifdef __linux__
  cpu_set_t processors;
  if (sched_getaffinity (0, sizeof (processors), &processors) == 0)
    return static_cast<std::size_t> (CPU_COUNT (&processors));
#endif
  return std::max (1u, std::thread::hardware_concurrency());
}

void
callOnWorkers (std::size_t number, const std::function<void()>& task)
{
  Workers::ofTheProcess().call (number, task);
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stage_lines.h"

#include "progress.h"

#include <system_error>
#include <utility>

namespace pcl_ops::apps {

StageLines::StageLines (std::ostream& stream, std::chrono::milliseconds between)
: stream_ (stream), between_ (between)
{
  try {
    thread_ = std::thread ([this] { writeLines(); });
  }
  catch (const std::system_error&) {
    // The work itself can be done without.
  }
}

StageLines::~StageLines() { end(); }

void
StageLines::begin (std::string stage)
{
  const std::lock_guard<std::mutex> lock (mutex_);
  stage_ = std::move (stage);
}

void
StageLines::end()
{
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    is_ended_ = true;
  }
  has_ended_.notify_all();
  if (thread_.joinable())
    thread_.join();
}

void
StageLines::writeLines()
{
  std::unique_lock<std::mutex> lock (mutex_);
  while (!has_ended_.wait_for (lock, between_, [this] { return is_ended_; })) {
    const std::chrono::duration<double> elapsed = Clock::now() - start_;
    stream_ << stage_ << ", " << durationText (elapsed.count()) << " so far"
            << std::endl;
  }
}

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <boost/format.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <system_error>
#include <vector>

namespace pcl_ops::apps {

namespace {

/** \brief Letters within the brackets of a bar. With the text behind it the line still
 * fits into the 80 columns of a terminal. */
constexpr std::size_t bar_width = 30;
/** \brief Moves a terminal to the beginning of its line, which it erases. */
constexpr const char* erase_line = "\r\033[K";

} // namespace

void
Progress::note (const std::string& line, std::ostream& stream)
{
  const std::lock_guard<std::mutex> lock (mutex_);
  if (has_bar_)
    stream_ << erase_line << std::flush;
  stream << line << std::endl;
  if (has_bar_)
    draw();
}

void
Progress::erase()
{
  const std::lock_guard<std::mutex> lock (mutex_);
  if (has_bar_)
    stream_ << erase_line << std::flush;
  has_bar_ = false;
}

void
Progress::draw()
{
  const Clock::time_point now = Clock::now();
  const bool is_too_early =
      style_ == ProgressStyle::Lines && now - last_line_ < between_;
  if (style_ == ProgressStyle::None || is_too_early)
    return;
  last_line_ = now;
  const std::size_t divisor = std::max<std::size_t> (1, steps_); // steps_ may be 0
  if (style_ == ProgressStyle::Bar) {
    const std::size_t filled = bar_width * std::min (done_, divisor) / divisor;
    stream_ << erase_line << '[' << std::string (filled, '=')
            << std::string (bar_width - filled, ' ') << "] ";
  }
  const double elapsed = std::chrono::duration<double> (now - start_).count(); // [s]
  // This takes a remaining step to last as long as the mean of those that are done.
  const double remaining = elapsed *
                           static_cast<double> (steps_ - std::min (done_, steps_)) /
                           static_cast<double> (done_); // [s]
  stream_ << done_ << " of " << steps_ << " " << noun_ << ", " << 100 * done_ / divisor
          << " %, "
          << (done_ < steps_ ? durationText (remaining) + " left"
                             : "took " + durationText (elapsed));
  has_bar_ = style_ == ProgressStyle::Bar && done_ < steps_;
  stream_ << (has_bar_ ? "" : "\n") << std::flush;
}

std::string
durationText (double seconds)
{
  constexpr long minute = 60; // [s]
  constexpr long hour = 60 * minute;
  const long whole_seconds = std::lround (std::max (0.0, seconds));
  const long minutes = whole_seconds % hour / minute;
  using boost::format;
  if (whole_seconds < minute)
    return std::to_string (whole_seconds) + " s";
  if (whole_seconds < hour)
    return str (format ("%d min %02d s") % minutes % (whole_seconds % minute));
  return str (format ("%d h %02d min") % (whole_seconds / hour) % minutes);
}

StageLines::StageLines (std::ostream& stream, std::chrono::milliseconds between)
: stream_ (stream), between_ (between)
{
  try {
    thread_ = std::thread ([this] { writeLines(); });
  }
  catch (const std::system_error&) {
    // The task goes on without lines.
  }
}

void
StageLines::end()
{
  if (!thread_.joinable())
    return;
  end_.set_value();
  thread_.join();
}

void
StageLines::writeLines()
{
  const std::future<void> end = end_.get_future();
  while (end.wait_for (between_) == std::future_status::timeout) {
    const std::lock_guard<std::mutex> lock (mutex_);
    const std::chrono::duration<double> elapsed = Clock::now() - start_;
    stream_ << stage_ << ", " << durationText (elapsed.count()) << " so far"
            << std::endl;
  }
}

void
runInParallel (std::size_t count,
               unsigned jobs,
               const std::function<void (std::size_t)>& work)
{
  std::atomic<std::size_t> next{0};
  const auto call_work = [&] {
    try {
      std::size_t i = next++;
      while (i < count) {
        work (i);
        i = next++;
      }
    }
    catch (...) {
      next = count; // no further call begins
      throw;
    }
  };
  const unsigned threads = jobs == 0 ? std::thread::hardware_concurrency() : jobs;
  // The other threads: this one works, too. If it throws, the destructors of the
  // futures wait for the others.
  std::vector<std::future<void>> others;
  try {
    for (std::size_t i = 1; i < std::min<std::size_t> (threads, count); ++i)
      others.push_back (std::async (std::launch::async, call_work));
  }
  catch (const std::exception&) {
    // The system starts no more threads: this one and those that did start do the work.
  }
  call_work();
  for (std::future<void>& other : others)
    other.get();
}

} // namespace pcl_ops::apps

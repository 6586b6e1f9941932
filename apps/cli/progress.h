// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>
#include <utility>

namespace pcl_ops::apps {

/** \brief How progress is shown. */
enum class ProgressStyle {
  /** \brief For terminals: a bar with the remaining time, in one line that is written
   * again at each step. */
  Bar,
  /** \brief For files: a line at a step, but at least ten seconds after the last line,
   * or after the start. */
  Lines,
  None
};

/** \brief Returns the style for a stream. */
inline ProgressStyle
progressStyleOf (bool is_terminal)
{
  return is_terminal ? ProgressStyle::Bar : ProgressStyle::Lines;
}

/** \brief Shows the progress of a long run. Several threads may use it. */
class Progress {
public:
  /** \param[in] steps number of steps of the whole run
   * \param[in] noun what a step is, in the plural
   * \param[in] between shortest time from one line to the next, for
   * ProgressStyle::Lines */
  Progress (std::size_t steps,
            std::ostream& stream,
            ProgressStyle style,
            std::string noun = "clouds",
            std::chrono::milliseconds between = std::chrono::seconds (10))
  : steps_ (steps)
  , stream_ (stream)
  , style_ (style)
  , noun_ (std::move (noun))
  , between_ (between)
  {}
  ~Progress() { erase(); }

  /** \brief Counts a step as done. */
  void
  step ()
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    ++done_;
    draw();
  }

  /** \brief Writes a line to \p stream, in place of the bar, and the bar again below
   * it: \p stream may be the same terminal as that of the bar. */
  void
  note (const std::string& line, std::ostream& stream);

  /** \brief Writes a line to the stream of the progress. */
  void
  note (const std::string& line)
  {
    note (line, stream_);
  }

  /** \brief Erases the bar. */
  void
  erase ();

private:
  using Clock = std::chrono::steady_clock;

  /** \brief Writes the bar, or a line if it is time for one. The caller locks. */
  void
  draw ();

  /** \brief Number of steps of the whole run. */
  std::size_t steps_;
  /** \brief Number of steps that are done. */
  std::size_t done_ = 0;
  std::ostream& stream_;
  ProgressStyle style_;
  std::string noun_;
  std::chrono::milliseconds between_;
  /** \brief Whether the last line of the stream is a bar. */
  bool has_bar_ = false;
  Clock::time_point start_ = Clock::now();
  /** \brief When the last line or bar was written; at first the start. */
  Clock::time_point last_line_ = start_;
  /** \brief Guards all members. */
  std::mutex mutex_;
};

/** \brief Returns a duration as text: "42 s", "3 min 07 s", "2 h 05 min". */
std::string
durationText (double seconds);

/** \brief Writes the current stage of a long task with few steps: a line every ten
 * seconds, by a thread of its own; no line if the task takes less, or if no thread can
 * start. */
class StageLines {
public:
  /** \param[in] stream is written to until \ref end
   * \param[in] between time from one line to the next */
  explicit StageLines (std::ostream& stream,
                       std::chrono::milliseconds between = std::chrono::seconds (10));
  ~StageLines() { end(); }

  /** \brief Sets the stage that the following lines name. */
  void
  begin (std::string stage)
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    stage_ = std::move (stage);
  }

  /** \brief Ends the thread; no line follows. */
  void
  end ();

private:
  using Clock = std::chrono::steady_clock;

  /** \brief The work of the thread. */
  void
  writeLines ();

  std::ostream& stream_;
  std::chrono::milliseconds between_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::string stage_;
  /** \brief Set to end the thread. */
  std::promise<void> end_;
  /** \brief The last member, as its work uses all others. */
  std::thread thread_;
};

/** \brief Calls \p work with 0, 1, ... \p count - 1; the calls begin in this order.
 * After an exception no further call begins, and one of the exceptions is rethrown once
 * the running calls have returned.
 * \param[in] jobs number of calls at the same time, fewer if the system starts no more
 * threads; 0: as many as there are processors */
void
runInParallel (std::size_t count,
               unsigned jobs,
               const std::function<void (std::size_t)>& work);

} // namespace pcl_ops::apps

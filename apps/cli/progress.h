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

enum class ProgressStyle {
  /** \brief A bar with the time left, for terminals: it overwrites itself. */
  Bar,
  /** \brief A line every ten seconds, none if the run ends before; for files. */
  Lines,
  None
};

inline ProgressStyle
progressStyleOf (bool is_terminal)
{
  return is_terminal ? ProgressStyle::Bar : ProgressStyle::Lines;
}

/** \brief Tells how far a long run is. May be used by several threads. */
class Progress {
public:
  /** \param[in] noun what a step is about, in the plural
   * \param[in] between time from one line to the next */
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

  void
  step ()
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    ++done_;
    draw();
  }

  /** \brief Writes a line to a stream that may be the same terminal, above a bar. */
  void
  note (const std::string& line, std::ostream& stream);
  void
  note (const std::string& line)
  {
    note (line, stream_);
  }

  /** \brief Takes the bar away. */
  void
  erase ();

private:
  using Clock = std::chrono::steady_clock;

  void
  draw ();

  std::size_t steps_;
  std::size_t done_ = 0;
  std::ostream& stream_;
  ProgressStyle style_;
  std::string noun_;
  std::chrono::milliseconds between_;
  bool has_bar_ = false;
  Clock::time_point start_ = Clock::now(), last_line_ = start_;
  std::mutex mutex_;
};

/** \brief "42 s", "3 min 07 s", "2 h 05 min". */
std::string
durationText (double seconds);

/** \brief Tells the stage of a long work of few steps: a line each ten seconds, and
 * none where all is done before. Without room for one more thread it is silent. */
class StageLines {
public:
  /** \param[in] stream used by a thread of its own until \ref end */
  explicit StageLines (std::ostream& stream,
                       std::chrono::milliseconds between = std::chrono::seconds (10));
  ~StageLines() { end(); }

  void
  begin (std::string stage)
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    stage_ = std::move (stage);
  }

  void
  end ();

private:
  using Clock = std::chrono::steady_clock;

  void
  writeLines ();

  std::ostream& stream_;
  std::chrono::milliseconds between_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::string stage_;
  std::promise<void> end_;
  std::thread thread_;
};

/** \brief Calls \p work with 0, 1, ... \p count - 1, begun in this order. What it
 * throws ends the run once the calls under way have returned, and is thrown again.
 * \param[in] jobs calls at a time, fewer where the system starts no more threads; 0: as
 * many as there are processors */
void
runInParallel (std::size_t count,
               unsigned jobs,
               const std::function<void (std::size_t)>& work);

} // namespace pcl_ops::apps

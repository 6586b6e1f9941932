// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <mutex>
#include <ostream>
#include <string>

namespace pcl_ops::evaluation {

/** \brief Tells how far a long run is: a bar with the time left on a terminal, a plain
 * line for each whole per cent otherwise. May be used by several threads. */
class Progress {
public:
  /** \param[in] steps number of calls of \ref step to come
   * \param[in] stream where to write
   * \param[in] is_terminal whether lines can be overwritten there */
  Progress (std::size_t steps, std::ostream& stream, bool is_terminal);

  /** \brief Counts one piece of work as done. */
  void
  step ();

  /** \brief Writes a line of its own. */
  void
  note (const std::string& line);

private:
  void
  draw ();

  using Clock = std::chrono::steady_clock;

  std::size_t steps_;
  std::size_t done_ = 0;
  std::size_t percent_drawn_ = 0;
  std::ostream& stream_;
  bool is_terminal_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
};

/** \brief A duration as a person says it: "42 s", "3 min 07 s", "2 h 05 min". */
std::string
durationText (double seconds);

} // namespace pcl_ops::evaluation

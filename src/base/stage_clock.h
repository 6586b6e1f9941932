// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace pcl_ops::internal {

/** \brief Stopwatch for the stages of a detection; it starts when it is constructed. */
class StageClock {
public:
  /** \brief Adds to \p duration [ms] the wall time since the last call of this
   * function, or since the start if this is the first call. */
  void
  lap (double& duration)
  {
    const double total_now = total();
    duration += total_now - total_at_last_lap_;
    total_at_last_lap_ = total_now;
  }

  /** \brief Wall time since the start [ms]. */
  double
  total () const
  {
    return std::chrono::duration<double, std::milli> (Clock::now() - start_).count();
  }

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_ = Clock::now();
  double total_at_last_lap_ = 0.0; // [ms]
};

} // namespace pcl_ops::internal

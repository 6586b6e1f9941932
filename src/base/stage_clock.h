// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace pcl_ops::internal {

/** \brief Stopwatch for the stages of a detection; runs from its construction. */
class StageClock {
public:
  /** \brief Adds to \p duration the wall time since the last lap or the start [ms]. */
  void
  lap (double& duration)
  {
    const double now = total();
    duration += now - last_;
    last_ = now;
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
  double last_ = 0.0;
};

} // namespace pcl_ops::internal

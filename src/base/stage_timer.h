// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/time.h>

namespace pcl_ops {

/** \brief Adds the wall time of a scope to a stage's duration [ms]. */
class StageTimer {
public:
  explicit StageTimer (double& duration) : duration_ (duration) {}
  ~StageTimer() { duration_ += watch_.getTime(); }
  StageTimer (const StageTimer&) = delete;
  StageTimer&
  operator= (const StageTimer&) = delete;

private:
  double& duration_;
  pcl::StopWatch watch_;
};

/** \brief Runs a stage and adds its wall time to a duration [ms].
 * \return what the stage returns */
template <typename Stage>
auto
timed (double& duration, Stage&& stage)
{
  const StageTimer timer (duration);
  return stage();
}

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/time.h>

namespace pcl_ops::evaluation {

/** \brief Runs something and adds its wall time to a duration [ms]. */
template <typename Work>
auto
timed (double& duration, Work&& work)
{
  struct Watch {
    double& duration;
    pcl::StopWatch watch;
    ~Watch() { duration += watch.getTime(); }
  } const watch{duration, {}};
  return work();
}

} // namespace pcl_ops::evaluation

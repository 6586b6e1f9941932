// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "median_place.h"

#include <numbers/quantile.h>

#include <utility>

namespace pcl_ops::apps {

Eigen::Vector3d
medianPlace (const std::vector<Eigen::Vector3d>& places)
{
  Eigen::Vector3d median;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> coordinates;
    coordinates.reserve (places.size());
    for (const Eigen::Vector3d& place : places)
      coordinates.push_back (place[axis]);
    median[axis] = quantile (std::move (coordinates), 0.5);
  }
  return median;
}

} // namespace pcl_ops::apps

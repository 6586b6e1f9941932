// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <simulation/simulated_cloud.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

inline bool
haveSamePoints (const SimulatedCloud& a, const SimulatedCloud& b)
{
  return std::equal (a.cloud.begin(),
                     a.cloud.end(),
                     b.cloud.begin(),
                     b.cloud.end(),
                     [] (const auto& p, const auto& q) {
                       return p.getVector3fMap() == q.getVector3fMap() &&
                              p.label == q.label;
                     });
}

inline double
largestDistanceToTruth (const SimulatedCloud& simulated)
{
  double largest = 0.0;
  for (const auto& point : simulated.cloud)
    if (point.label > 0) {
      const auto& plane = simulated.planes.at (point.label - 1).plane;
      const Eigen::Vector3d position = point.getVector3fMap().cast<double>();
      largest = std::max (largest, std::abs (plane.distance (position)));
    }
  return largest;
}

/** \brief A few ulp of single precision at room size [m]. */
constexpr double rounding = 2e-6;

/** \brief No draw of a Gaussian with 32 random bits is farther from 0 [sigma]. */
constexpr double largest_gaussian = 6.67;

} // namespace pcl_ops::simulation

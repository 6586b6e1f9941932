// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/coordinate_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

namespace {

/** \brief The smallest distance between different coordinates along an axis [m]. */
struct LeastDistance {
  double length = 0.0;
  std::size_t times = 0; // that it occurs
};

// In units of the step: coordinates far from zero are rounded again to single
// precision.
constexpr double tolerance = 0.1;

LeastDistance
leastDistance (const std::vector<float>& coordinates)
{
  constexpr std::size_t looked_at = 16384;
  const std::size_t stride = coordinates.size() / looked_at + 1;
  std::vector<float> values;
  for (std::size_t i = 0; i < coordinates.size(); i += stride)
    values.push_back (coordinates[i]);
  std::sort (values.begin(), values.end());
  values.erase (std::unique (values.begin(), values.end()), values.end());
  std::vector<double> distances;
  for (std::size_t i = 1; i < values.size(); ++i)
    distances.push_back (values[i] - values[i - 1]);
  if (distances.empty())
    return {};
  LeastDistance least;
  least.length = *std::min_element (distances.begin(), distances.end());
  for (const double distance : distances)
    least.times += distance <= (1.0 + tolerance) * least.length ? 1 : 0;
  return least;
}

} // namespace

Eigen::Vector3d
coordinateSteps (const Coordinates& points)
{
  // The least distance of coordinates that were not rounded occurs once.
  constexpr std::size_t least_often = 12;
  const std::array<LeastDistance, 3> least = {
      leastDistance (points.x), leastDistance (points.y), leastDistance (points.z)};
  Eigen::Vector3d steps = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis)
    // A level floor has too few heights to repeat its step so often. So the step counts
    // if it agrees with that of any axis that does.
    for (const LeastDistance& other : least)
      if (other.times >= least_often &&
          std::abs (least[axis].length - other.length) <= tolerance * other.length)
        steps[axis] = least[axis].length;
  return steps;
}

} // namespace pcl_ops::internal

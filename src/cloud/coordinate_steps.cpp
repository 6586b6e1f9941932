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

/** \brief The smallest difference of two different coordinates along an axis. */
struct SmallestDifference {
  double length = 0.0; // [m]; 0 if all coordinates are equal
  std::size_t occurrences = 0;
};

// Differences are equal if they differ by at most this share of the smaller one. They
// do differ, because coordinates far from zero are rounded again to single precision.
constexpr double tolerance = 0.1; // chosen by hand

SmallestDifference
smallestDifference (const std::vector<float>& coordinates)
{
  constexpr std::size_t max_values = 16384; // limits the time, chosen by hand
  const std::size_t stride = coordinates.size() / max_values + 1;
  std::vector<float> values;
  for (std::size_t i = 0; i < coordinates.size(); i += stride)
    values.push_back (coordinates[i]);
  std::sort (values.begin(), values.end());
  values.erase (std::unique (values.begin(), values.end()), values.end());
  std::vector<double> differences; // of neighboring values
  for (std::size_t i = 1; i < values.size(); ++i)
    differences.push_back (values[i] - values[i - 1]);
  if (differences.empty())
    return {};
  SmallestDifference smallest;
  smallest.length = *std::min_element (differences.begin(), differences.end());
  for (const double difference : differences)
    smallest.occurrences += difference <= (1.0 + tolerance) * smallest.length ? 1 : 0;
  return smallest;
}

} // namespace

Eigen::Vector3d
coordinateSteps (const Coordinates& points)
{
  // The smallest difference of coordinates that were not rounded occurs once; a step
  // occurs often.
  constexpr std::size_t min_occurrences = 12; // chosen by hand
  const std::array<SmallestDifference, 3> smallest = {smallestDifference (points.x),
                                                      smallestDifference (points.y),
                                                      smallestDifference (points.z)};
  Eigen::Vector3d steps = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis)
    // The points of a level floor have too few different heights to repeat their step
    // so often. So a difference is a step, too, if it equals the step of another axis.
    for (const SmallestDifference& other : smallest)
      if (other.occurrences >= min_occurrences &&
          std::abs (smallest[axis].length - other.length) <= tolerance * other.length)
        steps[axis] = smallest[axis].length;
  return steps;
}

} // namespace pcl_ops::internal

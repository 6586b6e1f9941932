// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/voxel_size.h"

#include <Eigen/Geometry>

#include "cloud/sorted_points.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// Returns how many voxels have points in them.
double
countOccupied (const Coordinates& points, double voxel_size)
{
  constexpr unsigned one_thread = 1;
  const PointRuns runs = sortedRuns (points, voxel_size, one_thread);
  std::size_t voxels = runs.size() == 0 ? 0 : 1;
  for (std::size_t r = 1; r < runs.size(); ++r)
    voxels += runs[r].code() != runs[r - 1].code();
  return static_cast<double> (voxels);
}

// Drops outliers: points many times farther from the origin than the median distance.
// Each one would fill a voxel of its own at any size. The origin is near most points.
Coordinates
withoutOutliers (const Coordinates& points)
{
  constexpr double medians_to_outlier = 32.0;
  std::vector<float> distances;
  distances.reserve (points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    distances.push_back (static_cast<float> (points[i].norm()));
  const double max_distance = medians_to_outlier * medianOf (distances);
  Coordinates kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!(points[i].norm() > max_distance))
      kept.add (points.x[i], points.y[i], points.z[i]);
  return kept;
}

} // namespace

double
roundNumber (double size)
{
  const double power_of_ten = std::pow (10.0, std::floor (std::log10 (size)));
  const double mantissa = size / power_of_ten; // 1 to 10
  const double step = power_of_ten * (mantissa < 2.0   ? 0.1
                                      : mantissa < 5.0 ? 0.25
                                                       : 1.0);
  return std::round (size / step) * step;
}

double
voxelSizeFor (const Coordinates& points, double wanted_voxels)
{
  constexpr std::size_t sample_size = 8192;
  // About ten sampled points per voxel: hardly any occupied voxel has no sampled point.
  constexpr double max_counted_voxels = 800.0;
  // The first size to try is the diagonal of the bounding box over this number.
  constexpr double sizes_per_diagonal = 25.0;
  const Coordinates sample = withoutOutliers (samplePoints (points, sample_size));
  if (sample.size() == 0)
    return 0.0;
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < sample.size(); ++i)
    box.extend (sample[i]);
  double voxel_size = box.diagonal().norm() / sizes_per_diagonal;
  if (!(voxel_size > 0.0 && std::isfinite (voxel_size)))
    return 0.0;
  constexpr int max_tries = 8;
  double counted = countOccupied (sample, voxel_size);
  for (int i = 0; i < max_tries; ++i) {
    const double ratio = counted / std::min (max_counted_voxels, wanted_voxels);
    const bool is_near_enough = ratio > 0.5 && ratio < 2.0;
    if (is_near_enough)
      break;
    voxel_size *= std::sqrt (ratio); // surfaces fill edge^-2 voxels
    counted = countOccupied (sample, voxel_size);
  }
  return roundNumber (voxel_size * std::sqrt (counted / wanted_voxels));
}

} // namespace pcl_ops::internal

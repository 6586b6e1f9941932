// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/voxel_size.h"

#include <Eigen/Geometry>

#include "cloud/sorted_points.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

std::size_t
countOccupied (const Coordinates& positions, double voxel_size)
{
  const PointRuns runs = sortedRuns (positions, voxel_size, 1);
  std::size_t voxels = runs.size() == 0 ? 0 : 1;
  for (std::size_t r = 1; r < runs.size(); ++r)
    voxels += runs[r].code() != runs[r - 1].code();
  return voxels;
}

// Drops outliers: points many times farther from the origin than the median distance.
// Each one would fill a voxel of its own at any size. The origin is near most points.
Coordinates
withoutOutliers (const Coordinates& positions)
{
  constexpr double medians = 32.0;
  std::vector<float> distances;
  distances.reserve (positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    distances.push_back (static_cast<float> (positions[i].norm()));
  const double limit = medians * medianOf (distances);
  Coordinates kept;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!(positions[i].norm() > limit))
      kept.add (positions.x[i], positions.y[i], positions.z[i]);
  return kept;
}

} // namespace

double
roundNumber (double size)
{
  const double power = std::pow (10.0, std::floor (std::log10 (size)));
  const double digits = size / power;
  const double step = power * (digits < 2.0 ? 0.1 : digits < 5.0 ? 0.25 : 1.0);
  return std::round (size / step) * step;
}

double
voxelSizeFor (const Coordinates& positions, double wanted_voxels)
{
  constexpr std::size_t looked_at = 8192;
  // About ten sampled points per voxel: hardly any occupied voxel has no sampled point.
  constexpr double counted_voxels = 800.0;
  const Coordinates some = withoutOutliers (samplePoints (positions, looked_at));
  if (some.size() == 0)
    return 0.0;
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < some.size(); ++i)
    box.extend (some[i]);
  double voxel_size = box.diagonal().norm() / 25.0;
  if (!(voxel_size > 0.0 && std::isfinite (voxel_size)))
    return 0.0;
  constexpr int most_tries = 8;
  double counted = 0.0;
  for (int i = 0; i < most_tries; ++i) {
    counted = static_cast<double> (countOccupied (some, voxel_size));
    const double ratio = counted / std::min (counted_voxels, wanted_voxels);
    if (ratio > 0.5 && ratio < 2.0)
      break;
    voxel_size *= std::sqrt (ratio);
  }
  return roundNumber (voxel_size * std::sqrt (counted / wanted_voxels));
}

} // namespace pcl_ops::internal

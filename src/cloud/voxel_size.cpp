// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/voxel_size.h"

#include <Eigen/Geometry>

#include "cloud/sorted_points.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// Returns how many voxels have points, which is how often the code changes along the
// sorted runs, plus one.
double
countOccupied (const Coordinates& points, double voxel_size)
{
  constexpr unsigned one_thread = 1;
  const PointRuns runs = sortedRuns (points, voxel_size, one_thread);
  std::size_t voxels = runs.size() == 0 ? 0 : 1;
  for (std::size_t run = 1; run < runs.size(); ++run)
    voxels += runs[run].code() != runs[run - 1].code() ? 1 : 0;
  return static_cast<double> (voxels);
}

// Drops outliers: points many times farther from the origin, which is near most points,
// than the median distance. Each outlier would occupy a voxel of its own at any voxel
// size.
Coordinates
withoutOutliers (const Coordinates& points)
{
  constexpr double medians_to_outlier = 32.0; // chosen by hand
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
  constexpr std::size_t sample_size = 8192; // limits the time
  // About ten sampled points per voxel: hardly any occupied voxel has no sampled point.
  constexpr double max_counted_voxels = 800.0;
  // The voxel size that is tried first is the diagonal of the bounding box over this
  // number, chosen by hand: further tries correct it.
  constexpr double voxels_along_diagonal = 25.0;
  const Coordinates sample = withoutOutliers (samplePoints (points, sample_size));
  if (sample.size() == 0)
    return 0.0;
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < sample.size(); ++i)
    box.extend (sample[i]);
  double voxel_size = box.diagonal().norm() / voxels_along_diagonal;
  if (!(voxel_size > 0.0 && std::isfinite (voxel_size)))
    return 0.0;
  constexpr int max_tries = 8; // of points on no surface the number may not converge
  double counted = countOccupied (sample, voxel_size);
  for (int i = 0; i < max_tries; ++i) {
    const double ratio = counted / std::min (max_counted_voxels, wanted_voxels);
    // The extrapolation below corrects the rest.
    const bool is_near_enough = ratio > 0.5 && ratio < 2.0;
    if (is_near_enough)
      break;
    voxel_size *= std::sqrt (ratio); // as the number of voxels grows with 1 / edge^2
    counted = countOccupied (sample, voxel_size);
  }
  return roundNumber (voxel_size * std::sqrt (counted / wanted_voxels));
}

} // namespace pcl_ops::internal

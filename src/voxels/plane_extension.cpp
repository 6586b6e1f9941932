// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/plane_extension.h"

#include "geometry/noise_ratios.h"
#include "geometry/plane_statistics.h"
#include "voxels/bounded_planes.h"
#include "voxels/plane_bands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl_ops::internal {

namespace {

// The band of each plane, by the moments of its points. Planes narrower than a voxel
// get a band of width 0, and are not extended: else a plane of a car would continue
// across the street.
std::vector<PlaneBand>
bandsOf (const std::vector<Moments>& moments_of_planes,
         double voxel_size,
         double min_noise,
         double max_distance)
{
  std::vector<PlaneBand> bands (moments_of_planes.size());
  for (std::size_t p = 0; p < bands.size(); ++p) {
    const std::optional<PlaneFit> fit = fitPlane (moments_of_planes[p]);
    if (!fit || squared_width_of_variance * fit->variances[1] < voxel_size * voxel_size)
      continue;
    const double noise = std::max (std::sqrt (fit->variances[0]), min_noise);
    bands[p] = PlaneBand (
        fit->plane, noise, std::min (like_noise_ratio * noise, max_distance));
  }
  return bands;
}

// For each larger voxel the planes of the points in it, from the labels of all points.
std::vector<Labels>
planesOfPoints (const LargerVoxels& larger, const VoxelGrid& grid, const Labels& labels)
{
  std::vector<Labels> planes (larger.codes.size());
  for (std::size_t voxel = 0; voxel < grid.size(); ++voxel) {
    std::int32_t last_plane = no_plane;
    for (const std::uint32_t point : grid.pointsOf (voxel)) {
      if (labels[point] != last_plane)
        addOnce (labels[point], planes[larger.holding[voxel]]);
      last_plane = labels[point];
    }
  }
  return planes;
}

// For each larger voxel the planes in the smaller voxels that it contains.
std::vector<Labels>
planesOfSmaller (const LargerVoxels& larger,
                 const std::vector<Labels>& planes_in_smaller)
{
  std::vector<Labels> planes (larger.codes.size());
  for (std::size_t voxel = 0; voxel < planes_in_smaller.size(); ++voxel)
    for (const std::int32_t plane : planes_in_smaller[voxel])
      addOnce (plane, planes[larger.holding[voxel]]);
  return planes;
}

// The planes in a voxel and its neighbors, each once, from the planes in each voxel.
Labels
planesAround (const VoxelNeighbors& neighbors,
              std::size_t voxel,
              const std::vector<Labels>& planes)
{
  Labels around;
  for (const std::uint32_t neighbor : neighbors[voxel])
    for (const std::int32_t plane : planes[neighbor])
      addOnce (plane, around);
  return around;
}

// Gives open points without a plane the likeliest plane around their voxels. Points of
// the same voxel follow each other, so that its planes are found once.
void
extendToVoxels (const Coordinates& points,
                const std::vector<OpenPoint>& open,
                const LargerVoxels& larger,
                const std::vector<Labels>& planes_in_voxel,
                const std::vector<PlaneBand>& bands,
                Labels& labels)
{
  Labels around;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto [point, voxel] = open[i];
    if (i == 0 || voxel != open[i - 1].voxel)
      around = planesAround (larger.neighbors, voxel, planes_in_voxel);
    if (labels[point] == no_plane)
      labels[point] = likeliestOf (around, bands, points, point);
  }
}

} // namespace

void
extendPlanes (const Coordinates& points,
              const VoxelGrid& grid,
              std::vector<OpenPoint> open,
              int doublings,
              std::optional<double> distance_threshold,
              AssignedPoints& assigned)
{
  if (open.empty())
    return;
  Labels& labels = assigned.labels;
  const double max_distance =
      distance_threshold.value_or (std::numeric_limits<double>::infinity());
  double voxel_size = grid.voxel_size;
  std::vector<Labels> planes; // in each voxel of the level
  const std::size_t levels =
      std::min (static_cast<std::size_t> (doublings), grid.larger.size());
  for (std::size_t level = 0; level < levels; ++level) {
    const LargerVoxels& larger = grid.larger[level];
    voxel_size *= 2.0;
    const std::vector<PlaneBand> bands =
        bandsOf (assigned.moments, voxel_size, minNoise (grid), max_distance);
    planes = level == 0 ? planesOfPoints (larger, grid, labels)
                        : planesOfSmaller (larger, planes);
    // Replaces the voxel of the level below by that of this level.
    for (OpenPoint& open_point : open)
      open_point.voxel = larger.holding[open_point.voxel];
    extendToVoxels (points, open, larger, planes, bands, labels);
    // The next level sees the planes that points have just got.
    for (const auto& [point, voxel] : open)
      addOnce (labels[point], planes[voxel]);
  }
  for (const auto& [point, voxel] : open)
    if (labels[point] != no_plane)
      assigned.moments[labels[point]].add (
          points.x[point], points.y[point], points.z[point]);
}

} // namespace pcl_ops::internal

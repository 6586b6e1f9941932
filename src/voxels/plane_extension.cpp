// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/plane_extension.h"

#include "geometry/noise_ratios.h"
#include "voxels/bounded_planes.h"
#include "voxels/plane_bands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl_ops::internal {

namespace {

// Planes narrower than a voxel get a band of width 0, and are not extended: else a
// plane of a car would continue across the street.
std::vector<PlaneBand>
bandsOf (const std::vector<Moments>& planes,
         double voxel_size,
         double smallest_noise,
         double largest_distance)
{
  std::vector<PlaneBand> bands (planes.size());
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const std::optional<PlaneFit> fit = fitPlane (planes[p]);
    // The width of an evenly covered strip is sqrt (12) standard deviations.
    if (!fit || 12.0 * fit->variances[1] < voxel_size * voxel_size)
      continue;
    const double noise = std::max (std::sqrt (fit->variances[0]), smallest_noise);
    bands[p] =
        PlaneBand (fit->plane, noise, std::min (like_noise * noise, largest_distance));
  }
  return bands;
}

// For each larger voxel the planes of its points, from the labels of all points.
std::vector<Labels>
planesInLarger (const LargerVoxels& larger, const VoxelGrid& grid, const Labels& labels)
{
  std::vector<Labels> planes (larger.codes.size());
  for (std::size_t voxel = 0; voxel < grid.size(); ++voxel) {
    std::int32_t last = no_plane;
    for (const std::uint32_t point : grid.pointsOf (voxel)) {
      if (labels[point] != last)
        addOnce (labels[point], planes[larger.holding[voxel]]);
      last = labels[point];
    }
  }
  return planes;
}

// For each larger voxel the planes in the smaller voxels that it contains.
std::vector<Labels>
planesInLarger (const LargerVoxels& larger, const std::vector<Labels>& planes)
{
  std::vector<Labels> joined (larger.codes.size());
  for (std::size_t voxel = 0; voxel < planes.size(); ++voxel)
    for (const std::int32_t plane : planes[voxel])
      addOnce (plane, joined[larger.holding[voxel]]);
  return joined;
}

// The planes of a voxel and its neighbors, each once.
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
                const std::vector<Labels>& planes,
                const std::vector<PlaneBand>& bands,
                Labels& labels)
{
  Labels around;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto [point, voxel] = open[i];
    if (i == 0 || voxel != open[i - 1].voxel)
      around = planesAround (larger.neighbors, voxel, planes);
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
  const double largest_distance =
      distance_threshold.value_or (std::numeric_limits<double>::infinity());
  double voxel_size = grid.voxel_size;
  std::vector<Labels> planes; // of each voxel of the level
  const auto wanted = static_cast<std::size_t> (doublings);
  for (std::size_t level = 0; level < std::min (wanted, grid.larger.size()); ++level) {
    const LargerVoxels& larger = grid.larger[level];
    voxel_size *= 2.0;
    const std::vector<PlaneBand> bands =
        bandsOf (assigned.moments, voxel_size, smallestNoise (grid), largest_distance);
    planes = level == 0 ? planesInLarger (larger, grid, labels)
                        : planesInLarger (larger, planes);
    // From the voxel of the level below to that of this level.
    for (OpenPoint& open_point : open)
      open_point.voxel = larger.holding[open_point.voxel];
    extendToVoxels (points, open, larger, planes, bands, labels);
    for (const auto& [point, voxel] : open)
      addOnce (labels[point], planes[voxel]);
  }
  for (const auto& [point, voxel] : open)
    if (labels[point] != no_plane)
      assigned.moments[labels[point]].add (
          points.x[point], points.y[point], points.z[point]);
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/plane_growing.h"

#include "base/parallel.h"

#include <algorithm>
#include <limits>

namespace pcl_ops::internal {

namespace {

// The plane of a neighbor with the least ratio of the rms distance of the voxel's
// points to the largest rms distance [m] that the plane allows. no_plane if no ratio is
// below 1.
std::int32_t
bestPlaneAround (const VoxelGrid& grid,
                 const BoundedPlanes& planes,
                 const std::vector<double>& max_rms_of_plane,
                 std::size_t voxel)
{
  std::int32_t best = no_plane;
  // Successive neighbors mostly are on the same plane.
  std::int32_t last_plane = no_plane;
  double least_squared_ratio = 1.0;
  for (const std::uint32_t neighbor : grid.neighbors[voxel]) {
    const std::int32_t plane = planes.plane_of_voxel[neighbor];
    if (plane == last_plane || plane == no_plane)
      continue;
    last_plane = plane;
    const double squared_ratio =
        meanSquaredDistance (grid.moments[voxel], planes.planes[plane]) /
        (max_rms_of_plane[plane] * max_rms_of_plane[plane]);
    if (squared_ratio >= least_squared_ratio)
      continue;
    least_squared_ratio = squared_ratio;
    best = plane;
  }
  return best;
}

// The voxels without a plane.
Indices
openVoxels (const Labels& plane_of_voxel)
{
  Indices open;
  for (std::size_t i = 0; i < plane_of_voxel.size(); ++i)
    if (plane_of_voxel[i] == no_plane)
      open.push_back (static_cast<std::uint32_t> (i));
  return open;
}

// The voxels without a plane that touch one of the given voxels, each once.
Indices
openVoxelsNextTo (const VoxelGrid& grid,
                  const Indices& voxels,
                  const Labels& plane_of_voxel)
{
  Indices open;
  std::vector<char> is_listed (grid.size(), 0);
  for (const std::uint32_t voxel : voxels)
    for (const std::uint32_t neighbor : grid.neighbors[voxel])
      if (plane_of_voxel[neighbor] == no_plane && is_listed[neighbor] == 0) {
        is_listed[neighbor] = 1;
        open.push_back (neighbor);
      }
  return open;
}

} // namespace

void
growPlanes (const VoxelGrid& grid,
            std::optional<double> distance_threshold,
            unsigned threads,
            BoundedPlanes& planes)
{
  const double given_limit =
      distance_threshold.value_or (std::numeric_limits<double>::infinity());
  std::vector<double> max_rms_of_plane;
  for (const double noise : planes.noise)
    max_rms_of_plane.push_back (
        std::min (max_voxel_rms_in_noises * noise, given_limit));
  Indices open = openVoxels (planes.plane_of_voxel);
  while (!open.empty()) {
    Labels best_planes (open.size());
    forEach (threads, open.size(), [&] (std::size_t i) {
      best_planes[i] = bestPlaneAround (grid, planes, max_rms_of_plane, open[i]);
    });
    Indices taken;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (best_planes[i] != no_plane) {
        planes.plane_of_voxel[open[i]] = best_planes[i];
        taken.push_back (open[i]);
      }
    open = openVoxelsNextTo (grid, taken, planes.plane_of_voxel);
  }
  refitPlanes (grid, planes);
}

} // namespace pcl_ops::internal

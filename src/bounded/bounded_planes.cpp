// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/bounded_planes.h"

#include "bounded/noise_floors.h"
#include "detection/plane_assignment.h"
#include "voxels/voxel_traversal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pcl_ops::internal {

void
refitPlanes (const VoxelGrid& grid, BoundedPlanes& planes)
{
  const std::vector<Moments> moments = momentsOfPlanes (grid, planes);
  for (std::size_t p = 0; p < moments.size(); ++p)
    if (const std::optional<PlaneFit> fit = fitPlane (moments[p]))
      planes.planes[p] = fit->plane;
}

void
measureNoise (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes)
{
  // Of each voxel's points: the sum of squared distances, and how many they are.
  std::vector<std::array<double, 2>> distances (grid.size());
  forVoxels (grid, threads, [&] (std::size_t i) {
    if (planes.plane_of_voxel[i] == no_plane)
      return;
    const Moments& voxel = grid.moments[i];
    const auto own = static_cast<std::size_t> (planes.plane_of_voxel[i]);
    distances[i] = {voxel.count * meanSquaredDistance (voxel, planes.planes[own]),
                    voxel.count};
  });
  forVoxels (grid, threads, [&] (std::size_t i) {
    if (planes.plane_of_voxel[i] == no_plane)
      return;
    double sum = 0.0;
    double count = 0.0;
    for (const std::uint32_t neighbour : grid.neighbours[i])
      if (planes.plane_of_voxel[neighbour] == planes.plane_of_voxel[i]) {
        sum += distances[neighbour][0];
        count += distances[neighbour][1];
      }
    planes.noise[i] = std::max (std::sqrt (sum / count), smallestNoise (grid));
  });
}

void
reassignVoxels (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes)
{
  const Labels before = planes.plane_of_voxel;
  forVoxels (grid, threads, [&] (std::size_t i) {
    if (before[i] == no_plane)
      return;
    const auto own = static_cast<std::size_t> (before[i]);
    // Computed when another plane is met: most voxels have their own all around.
    std::optional<double> best;
    std::size_t last = own;
    forNeighboursOnPlanes (grid, before, i, [&] (std::size_t plane, std::size_t) {
      if (plane == own || plane == last)
        return;
      last = plane;
      if (!best)
        best = meanSquaredDistance (grid.moments[i], planes.planes[own]);
      const double squared =
          meanSquaredDistance (grid.moments[i], planes.planes[plane]);
      if (squared >= *best)
        return;
      best = squared;
      planes.plane_of_voxel[i] = static_cast<std::int32_t> (plane);
    });
  });
  refitPlanes (grid, planes);
}

std::vector<Moments>
momentsOfPlanes (const VoxelGrid& grid, const BoundedPlanes& planes)
{
  std::vector<Moments> moments (planes.planes.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes.plane_of_voxel[i] != no_plane)
      moments[static_cast<std::size_t> (planes.plane_of_voxel[i])].addAligned (
          grid.moments[i]);
  return moments;
}

void
renumberPlanes (const MergedPlanes& merged, BoundedPlanes& planes)
{
  relabel (planes.plane_of_voxel, merged.merged_into, 1);
  planes.planes.clear();
  for (const PlaneFit& fit : merged.fits)
    planes.planes.push_back (fit.plane);
}

Moments
momentsOf (const VoxelGrid& grid, const Indices& voxels)
{
  Moments moments;
  for (const std::uint32_t voxel : voxels)
    moments.addAligned (grid.moments[voxel]);
  return moments;
}

} // namespace pcl_ops::internal

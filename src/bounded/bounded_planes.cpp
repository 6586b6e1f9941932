// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/bounded_planes.h"

#include "detection/plane_assignment.h"
#include "voxels/voxel_traversal.h"

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
  std::vector<Moments> moments = planes.beyond;
  moments.resize (planes.planes.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes.plane_of_voxel[i] != no_plane)
      moments[static_cast<std::size_t> (planes.plane_of_voxel[i])].addAligned (
          grid.moments[i]);
  return moments;
}

void
relabelPlanes (const Labels& became, std::size_t number, BoundedPlanes& planes)
{
  relabel (planes.plane_of_voxel, became, 1);
  relabel (planes.became, became, 1);
  std::vector<Moments> beyond (planes.beyond.empty() ? 0 : number);
  for (std::size_t p = 0; p < planes.beyond.size(); ++p)
    if (became[p] != no_plane)
      beyond[static_cast<std::size_t> (became[p])].addAligned (planes.beyond[p]);
  planes.beyond = beyond;
}

void
renumberPlanes (const MergedPlanes& merged, BoundedPlanes& planes)
{
  relabelPlanes (merged.merged_into, merged.fits.size(), planes);
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

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/bounded_planes.h"

#include "base/parallel.h"
#include "detection/plane_assignment.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_ops::internal {

std::vector<Moments>
momentsOfPlanes (const VoxelGrid& grid, const BoundedPlanes& planes)
{
  std::vector<Moments> moments = planes.moments_elsewhere;
  moments.resize (planes.planes.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes.plane_of_voxel[i] != no_plane)
      moments[planes.plane_of_voxel[i]].addAligned (grid.moments[i]);
  return moments;
}

void
refitPlanes (const VoxelGrid& grid, BoundedPlanes& planes)
{
  const std::vector<Moments> moments = momentsOfPlanes (grid, planes);
  for (std::size_t p = 0; p < moments.size(); ++p)
    if (const std::optional<PlaneFit> fit = fitPlane (moments[p]))
      planes.planes[p] = fit->plane;
}

void
renumberPlanes (const MergedPlanes& merged, BoundedPlanes& planes)
{
  constexpr unsigned one_thread = 1;
  relabel (planes.plane_of_voxel, merged.merged_into, one_thread);
  std::vector<Moments> elsewhere (merged.fits.size());
  for (std::size_t p = 0; p < planes.moments_elsewhere.size(); ++p)
    if (merged.merged_into[p] != no_plane)
      elsewhere[merged.merged_into[p]].addAligned (planes.moments_elsewhere[p]);
  planes.moments_elsewhere = std::move (elsewhere);
  planes.noise.assign (merged.fits.size(), 0.0);
  planes.planes.clear();
  for (const PlaneFit& fit : merged.fits)
    planes.planes.push_back (fit.plane);
}

void
measureNoise (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes)
{
  const Labels& plane_of = planes.plane_of_voxel;
  // For each voxel on a plane the mean squared distance of its points to it [m^2].
  std::vector<float> mean_squares (grid.size());
  forEach (threads, grid.size(), [&] (std::size_t voxel) {
    if (plane_of[voxel] != no_plane)
      mean_squares[voxel] = static_cast<float> (
          meanSquaredDistance (grid.moments[voxel], planes.planes[plane_of[voxel]]));
  });
  std::vector<std::vector<float>> mean_squares_of_plane (planes.size());
  for (std::size_t voxel = 0; voxel < grid.size(); ++voxel)
    if (plane_of[voxel] != no_plane)
      mean_squares_of_plane[plane_of[voxel]].push_back (mean_squares[voxel]);
  planes.noise.resize (planes.size(), minNoise (grid));
  for (std::size_t p = 0; p < planes.size(); ++p)
    if (!mean_squares_of_plane[p].empty()) {
      const double mean_square = medianOf (mean_squares_of_plane[p]);
      planes.noise[p] = std::max (std::sqrt (mean_square), minNoise (grid));
    }
}

} // namespace pcl_ops::internal

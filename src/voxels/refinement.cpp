// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/refinement.h"

#include "base/parallel.h"
#include "voxels/plane_growing.h"

#include <algorithm>

namespace pcl_ops::internal {

namespace {

// Marks voxels without a plane that have enough points for finer voxels, and their
// neighbors, so that all finer voxels have neighbors. The neighbors of a voxel include
// itself.
std::vector<char>
voxelsToRefine (const VoxelGrid& grid, unsigned threads, const Labels& plane_of_voxel)
{
  // Chosen by hand: a point for each finer voxel. src/doc/constants.csv has F with 1.
  constexpr double min_points = 8.0;
  std::vector<char> is_refined (grid.size(), 0);
  forEach (threads, grid.size(), [&] (std::size_t i) {
    const IndexRange around = grid.neighbors[i];
    is_refined[i] =
        std::any_of (around.begin(), around.end(), [&] (std::uint32_t neighbor) {
          return plane_of_voxel[neighbor] == no_plane &&
                 grid.moments[neighbor].count >= min_points;
        });
  });
  return is_refined;
}

// Indices of the finest voxels in refined coarse voxels.
Indices
finestVoxelsIn (const Indices& coarse_of_finest, const std::vector<char>& is_refined)
{
  Indices voxels;
  for (std::size_t i = 0; i < coarse_of_finest.size(); ++i)
    if (is_refined[coarse_of_finest[i]] != 0)
      voxels.push_back (static_cast<std::uint32_t> (i));
  return voxels;
}

// A grid of the given voxels alone, without neighbors.
VoxelGrid
partOf (const VoxelGrid& grid, const Indices& voxels)
{
  VoxelGrid part;
  part.voxel_size = grid.voxel_size;
  part.order = grid.order;
  part.moments.reserve (voxels.size());
  for (const std::uint32_t voxel : voxels) {
    part.codes.push_back (grid.codes[voxel]);
    part.first_point.push_back (grid.first_point[voxel]);
    part.moments.push_back (grid.moments[voxel]);
  }
  return part;
}

// For each voxel of the grid \p finer the plane of its coarse voxel, if the points of
// the finer voxel lie on that plane; else no_plane.
// \param[in] finest_voxels for each voxel of finer its index among all finest voxels
Labels
inheritedPlanes (const BoundedPlanes& planes,
                 const Indices& coarse_of_finest,
                 const Indices& finest_voxels,
                 const VoxelGrid& finer,
                 unsigned threads)
{
  Labels inherited (finer.size(), no_plane);
  forEach (threads, finer.size(), [&] (std::size_t i) {
    const std::int32_t plane =
        planes.plane_of_voxel[coarse_of_finest[finest_voxels[i]]];
    if (plane == no_plane)
      return;
    const double max_rms = max_voxel_rms_in_noises * planes.noise[plane];
    if (meanSquaredDistance (finer.moments[i], planes.planes[plane]) <
        max_rms * max_rms)
      inherited[i] = plane;
  });
  return inherited;
}

// For each plane the moments of its points in coarse voxels that are not refined.
std::vector<Moments>
momentsInUnrefined (const VoxelGrid& coarse,
                    BoundedPlanes planes,
                    const std::vector<char>& is_refined)
{
  for (std::size_t i = 0; i < coarse.size(); ++i)
    if (is_refined[i] != 0)
      planes.plane_of_voxel[i] = no_plane;
  return momentsOfPlanes (coarse, planes);
}

} // namespace

Refinement
refine (const VoxelLevels& voxels, const BoundedPlanes& planes, unsigned threads)
{
  const VoxelGrid& coarse = voxels.coarse;
  Refinement finer;
  finer.is_refined = voxelsToRefine (coarse, threads, planes.plane_of_voxel);
  const Indices finest_voxels =
      finestVoxelsIn (voxels.coarse_of_finest, finer.is_refined);
  finer.grid = partOf (voxels.finest, finest_voxels);
  connect (finer.grid, threads);
  finer.planes.planes = planes.planes;
  finer.planes.noise = planes.noise;
  finer.planes.moments_elsewhere =
      momentsInUnrefined (coarse, planes, finer.is_refined);
  finer.planes.plane_of_voxel = inheritedPlanes (
      planes, voxels.coarse_of_finest, finest_voxels, finer.grid, threads);
  return finer;
}

} // namespace pcl_ops::internal

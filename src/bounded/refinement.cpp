// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/refinement.h"

#include "bounded/plane_growing.h"
#include "voxels/voxel_traversal.h"

#include <algorithm>

namespace pcl_ops::internal {

namespace {

// Voxels without a plane that hold points enough for one, and those next to them, so
// that finer voxels have neighbors.
std::vector<char>
voxelsToRefine (const VoxelGrid& grid, unsigned threads, const Labels& plane_of_voxel)
{
  constexpr double fewest_points = 8.0;
  std::vector<char> is_refined (grid.size(), 0);
  forVoxels (grid, threads, [&] (std::size_t i) {
    const VoxelRange& around = grid.neighbours[i];
    is_refined[i] =
        std::any_of (around.begin(), around.end(), [&] (std::uint32_t neighbour) {
          return plane_of_voxel[neighbour] == no_plane &&
                 grid.moments[neighbour].count >= fewest_points;
        });
  });
  return is_refined;
}

// The finest voxels of those that are refined.
void
select (const VoxelPyramid& voxels, Refinement& finer)
{
  const VoxelGrid& finest = voxels.grids[0];
  const Indices& coarse_of_finest = voxels.voxels_above[0];
  finer.grid.voxel_size = finest.voxel_size;
  finer.grid.moments.reserve (finest.size());
  for (std::size_t i = 0; i < finest.size(); ++i) {
    if (finer.is_refined[coarse_of_finest[i]] == 0)
      continue;
    finer.coarse_voxels.push_back (coarse_of_finest[i]);
    finer.grid.codes.push_back (finest.codes[i]);
    finer.grid.first_point.push_back (finest.first_point[i]);
    finer.grid.moments.push_back (finest.moments[i]);
  }
}

// The plane that each finer voxel has from the coarse one that holds it.
Labels
inheritedPlanes (const BoundedPlanes& planes, const Refinement& finer, unsigned threads)
{
  Labels inherited (finer.grid.size(), no_plane);
  forVoxels (finer.grid, threads, [&] (std::size_t i) {
    const std::int32_t plane = planes.plane_of_voxel[finer.coarse_voxels[i]];
    if (plane == no_plane)
      return;
    const auto p = static_cast<std::size_t> (plane);
    const double limit = noises_of_a_voxel * planes.noise[p];
    if (meanSquaredDistance (finer.grid.moments[i], planes.planes[p]) < limit * limit)
      inherited[i] = plane;
  });
  return inherited;
}

// Of each plane the moments of voxels that are not refined.
std::vector<Moments>
momentsLeft (const VoxelGrid& coarse,
             const BoundedPlanes& planes,
             const std::vector<char>& is_refined)
{
  std::vector<Moments> moments (planes.size());
  for (std::size_t i = 0; i < coarse.size(); ++i)
    if (planes.plane_of_voxel[i] != no_plane && is_refined[i] == 0)
      moments[static_cast<std::size_t> (planes.plane_of_voxel[i])].addAligned (
          coarse.moments[i]);
  return moments;
}

} // namespace

Refinement
refine (const VoxelPyramid& voxels, const BoundedPlanes& planes, unsigned threads)
{
  const VoxelGrid& coarse = voxels.grids[1];
  Refinement finer;
  finer.is_refined = voxelsToRefine (coarse, threads, planes.plane_of_voxel);
  select (voxels, finer);
  finer.grid.neighbours =
      neighboursOf (finer.grid.codes, finer.coarse_voxels, coarse.neighbours, threads);
  finer.planes.planes = planes.planes;
  finer.planes.noise = planes.noise;
  finer.planes.moments_elsewhere = momentsLeft (coarse, planes, finer.is_refined);
  finer.planes.plane_of_voxel = inheritedPlanes (planes, finer, threads);
  return finer;
}

} // namespace pcl_ops::internal

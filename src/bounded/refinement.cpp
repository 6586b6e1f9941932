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

void
append (const VoxelGrid& from, std::size_t voxel, VoxelGrid& grid)
{
  grid.codes.push_back (from.codes[voxel]);
  grid.first_point.push_back (from.first_point[voxel]);
  grid.moments.push_back (from.moments[voxel]);
}

// The finer voxels of those that are refined.
Refinement
selected (const VoxelGrid& finer, const Indices& voxels_above, const Refinement& coarse)
{
  Refinement part;
  part.grid.voxel_size = finer.voxel_size;
  part.grid.moments.reserve (finer.size());
  for (std::size_t i = 0; i < finer.size(); ++i) {
    if (coarse.is_refined[voxels_above[i]] == 0)
      continue;
    part.voxels_above.push_back (voxels_above[i]);
    append (finer, i, part.grid);
  }
  return part;
}

// The plane that each finer voxel has from the coarse one that holds it.
Labels
inheritedPlanes (const BoundedPlanes& planes, const Refinement& finer, unsigned threads)
{
  Labels inherited (finer.grid.size(), no_plane);
  forVoxels (finer.grid, threads, [&] (std::size_t i) {
    const std::int32_t plane = planes.plane_of_voxel[finer.voxels_above[i]];
    if (plane == no_plane)
      return;
    const auto p = static_cast<std::size_t> (plane);
    const double limit = noises_of_a_voxel * planes.noise[p];
    if (meanSquaredDistance (finer.grid.moments[i], planes.planes[p]) < limit * limit)
      inherited[i] = plane;
  });
  return inherited;
}

// Of each plane the moments of what is not refined.
std::vector<Moments>
momentsLeft (const Refinement& coarse)
{
  std::vector<Moments> moments = coarse.planes.moments_elsewhere;
  moments.resize (coarse.planes.size());
  for (std::size_t i = 0; i < coarse.grid.size(); ++i) {
    const std::int32_t plane = coarse.planes.plane_of_voxel[i];
    if (plane != no_plane && coarse.is_refined[i] == 0)
      moments[static_cast<std::size_t> (plane)].addAligned (coarse.grid.moments[i]);
  }
  return moments;
}

} // namespace

Refinement
refine (const VoxelGrid& finer,
        const Indices& voxels_above,
        unsigned threads,
        Refinement& coarse)
{
  coarse.is_refined =
      voxelsToRefine (coarse.grid, threads, coarse.planes.plane_of_voxel);
  Refinement part = selected (finer, voxels_above, coarse);
  part.grid.neighbours = neighboursOf (
      part.grid.codes, part.voxels_above, coarse.grid.neighbours, threads);
  part.planes.planes = coarse.planes.planes;
  part.planes.noise = coarse.planes.noise;
  part.planes.moments_elsewhere = momentsLeft (coarse);
  part.planes.plane_of_voxel = inheritedPlanes (coarse.planes, part, threads);
  return part;
}

OpenVoxels
openVoxels (const Refinement& part, int sizes, unsigned threads)
{
  OpenVoxels open;
  VoxelGrid grid;
  grid.voxel_size = part.grid.voxel_size;
  grid.moments.reserve (part.grid.size());
  for (std::size_t i = 0; i < part.grid.size(); ++i)
    if (part.planes.plane_of_voxel[i] == no_plane) {
      open.numbers.push_back (static_cast<std::uint32_t> (i));
      append (part.grid, i, grid);
    }
  open.voxels.grids.push_back (std::move (grid));
  open.voxels.voxels_above.emplace_back();
  for (int size = 1; size < sizes; ++size)
    coarsen (open.voxels);
  connect (open.voxels, threads);
  return open;
}

void
addPlanes (const Indices& numbers, const BoundedPlanes& found, BoundedPlanes& planes)
{
  const auto before = static_cast<std::int32_t> (planes.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (found.plane_of_voxel[i] != no_plane)
      planes.plane_of_voxel[numbers[i]] = before + found.plane_of_voxel[i];
  planes.planes.insert (planes.planes.end(), found.planes.begin(), found.planes.end());
}

} // namespace pcl_ops::internal

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

Indices
pointsToRefine (const VoxelizedPoints& coarse, const std::vector<char>& is_refined)
{
  const std::size_t size = coarse.voxel_of_point.size();
  Indices points (size);
  std::size_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    // Written always, counted if refined: no branch to mispredict.
    points[number] = static_cast<std::uint32_t> (i);
    number += static_cast<std::size_t> (is_refined[coarse.voxel_of_point[i]]);
  }
  points.resize (number);
  return points;
}

// Of each finer voxel the coarse one that holds it.
Indices
parentsOf (const VoxelizedPoints& coarse, const Refinement& refinement)
{
  Indices parents (refinement.voxelized.grid.size());
  for (std::size_t i = 0; i < refinement.points.size(); ++i)
    parents[refinement.voxelized.voxel_of_point[i]] =
        coarse.voxel_of_point[refinement.points[i]];
  return parents;
}

// The plane that each finer voxel has from the coarse one that holds it.
Labels
inheritedPlanes (const BoundedPlanes& planes,
                 const Indices& parents,
                 const VoxelGrid& finer,
                 unsigned threads)
{
  Labels inherited (finer.size(), no_plane);
  forVoxels (finer, threads, [&] (std::size_t i) {
    const std::int32_t plane = planes.plane_of_voxel[parents[i]];
    if (plane == no_plane)
      return;
    const auto p = static_cast<std::size_t> (plane);
    const double limit = noises_of_a_voxel * planes.noise[p];
    if (meanSquaredDistance (finer.moments[i], planes.planes[p]) < limit * limit)
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
refine (const Coordinates& points,
        const VoxelizedPoints& coarse,
        const BoundedPlanes& planes,
        unsigned threads)
{
  Refinement finer;
  finer.is_refined = voxelsToRefine (coarse.grid, threads, planes.plane_of_voxel);
  finer.points = pointsToRefine (coarse, finer.is_refined);
  finer.positions = selected (points, finer.points);
  if (!finer.points.empty())
    finer.voxelized = voxelize (finer.positions, 0.5 * coarse.grid.voxel_size, threads);
  finer.planes.planes = planes.planes;
  finer.planes.noise = planes.noise;
  finer.planes.moments_elsewhere = momentsLeft (coarse.grid, planes, finer.is_refined);
  finer.planes.plane_of_voxel = inheritedPlanes (
      planes, parentsOf (coarse, finer), finer.voxelized.grid, threads);
  return finer;
}

} // namespace pcl_ops::internal

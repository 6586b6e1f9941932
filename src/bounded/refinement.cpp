// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/refinement.h"

#include "voxels/voxel_traversal.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace pcl_ops::internal {

namespace {

bool
sharesAFace (const VoxelKey& a, const VoxelKey& b)
{
  return std::abs (a.x - b.x) + std::abs (a.y - b.y) + std::abs (a.z - b.z) <= 1;
}

// Voxels without a plane that hold points enough for one, and those next to them, so
// that finer voxels have neighbours.
std::vector<char>
voxelsToRefine (const VoxelGrid& grid, unsigned threads, const Labels& plane_of_voxel)
{
  constexpr double fewest_points = 8.0;
  const auto is_open = [&] (std::size_t voxel) {
    return plane_of_voxel[voxel] == no_plane &&
           grid.moments[voxel].count >= fewest_points;
  };
  std::vector<char> is_refined (grid.size(), 0);
  forVoxels (grid, threads, [&] (std::size_t i) {
    const VoxelRange& around = grid.neighbours[i];
    is_refined[i] =
        std::any_of (around.begin(), around.end(), [&] (std::uint32_t neighbour) {
          return is_open (neighbour) &&
                 sharesAFace (grid.keys[i], grid.keys[neighbour]);
        });
  });
  return is_refined;
}

Indices
pointsToRefine (const VoxelizedPoints& coarse,
                const std::vector<char>& is_refined,
                unsigned threads)
{
  constexpr std::size_t points_per_piece = 32768;
  Indices all;
  for (const Indices& piece :
       parallelPieces (threads,
                       coarse.voxel_of_point.size(),
                       points_per_piece,
                       [&] (std::size_t begin, std::size_t end) {
                         Indices points (end - begin);
                         std::size_t number = 0;
                         for (std::size_t i = begin; i < end; ++i) {
                           // Written always, counted if refined: no branch to
                           // mispredict.
                           points[number] = static_cast<std::uint32_t> (i);
                           number += static_cast<std::size_t> (
                               is_refined[coarse.voxel_of_point[i]]);
                         }
                         points.resize (number);
                         return points;
                       }))
    all.insert (all.end(), piece.begin(), piece.end());
  return all;
}

// Of each finer voxel the coarse one that holds it.
std::vector<std::uint32_t>
parentsOf (const VoxelizedPoints& coarse, const Refinement& refinement)
{
  std::vector<std::uint32_t> parents (refinement.voxelized.grid.size());
  for (std::size_t i = 0; i < refinement.points.size(); ++i)
    parents[refinement.voxelized.voxel_of_point[i]] =
        coarse.voxel_of_point[refinement.points[i]];
  return parents;
}

// Whether a finer voxel touches a coarse one next to its parent: along each axis that
// is the parent's own layer or, of the two next to it, the one on the voxel's side.
bool
touches (const VoxelKey& finer, const VoxelKey& parent, const VoxelKey& other)
{
  const auto along = [] (std::int32_t fine, std::int32_t from, std::int32_t to) {
    return to == from || to - from == ((fine & 1) != 0 ? 1 : -1);
  };
  return along (finer.x, parent.x, other.x) && along (finer.y, parent.y, other.y) &&
         along (finer.z, parent.z, other.z);
}

// Gives finer voxels to the planes of coarse ones they touch.
void
inheritPlanes (const VoxelGrid& coarse,
               const BoundedPlanes& planes,
               const std::vector<std::uint32_t>& parents,
               const VoxelGrid& finer,
               unsigned threads,
               BoundedPlanes& inherited)
{
  constexpr double noises = 2.0;
  inherited.plane_of_voxel.assign (finer.size(), no_plane);
  inherited.noise.assign (finer.size(), 0.0);
  forVoxels (finer, threads, [&] (std::size_t i) {
    double best = noises * noises;
    const auto consider = [&] (std::size_t plane, std::size_t neighbour) {
      if (!touches (finer.keys[i], coarse.keys[parents[i]], coarse.keys[neighbour]))
        return;
      const double noise = planes.noise[neighbour];
      const double ratio =
          meanSquaredDistance (finer.moments[i], planes.planes[plane]) /
          (noise * noise);
      if (ratio >= best)
        return;
      best = ratio;
      inherited.plane_of_voxel[i] = static_cast<std::int32_t> (plane);
      inherited.noise[i] = noise;
    };
    forNeighboursOnPlanes (coarse, planes.plane_of_voxel, parents[i], consider);
  });
}

// Of each plane the moments of voxels that are not refined.
std::vector<Moments>
momentsLeft (const VoxelGrid& coarse,
             const BoundedPlanes& planes,
             const std::vector<char>& is_refined)
{
  BoundedPlanes left = planes;
  for (std::size_t i = 0; i < coarse.size(); ++i)
    if (is_refined[i])
      left.plane_of_voxel[i] = no_plane;
  return momentsOfPlanes (coarse, left);
}

} // namespace

Refinement
refine (const Coordinates& points,
        const VoxelizedPoints& coarse,
        const BoundedPlanes& planes,
        unsigned threads)
{
  Refinement refinement;
  if (coarse.grid.size() == 0)
    return refinement;
  refinement.is_refined = voxelsToRefine (coarse.grid, threads, planes.plane_of_voxel);
  refinement.points = pointsToRefine (coarse, refinement.is_refined, threads);
  refinement.positions = selected (points, refinement.points);
  if (!refinement.points.empty())
    refinement.voxelized =
        voxelize (refinement.positions, 0.5 * coarse.grid.voxel_size, threads);
  BoundedPlanes& inherited = refinement.planes;
  inherited.planes = planes.planes;
  inherited.beyond = momentsLeft (coarse.grid, planes, refinement.is_refined);
  inherited.became.resize (planes.size());
  std::iota (inherited.became.begin(), inherited.became.end(), 0);
  inheritPlanes (coarse.grid,
                 planes,
                 parentsOf (coarse, refinement),
                 refinement.voxelized.grid,
                 threads,
                 inherited);
  return refinement;
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/hole_filling.h"

#include "voxels/voxel_traversal.h"

#include <optional>
#include <vector>

namespace pcl_ops::internal {

namespace {

/** \brief A voxel and the plane around it. */
struct Filling {
  std::size_t voxel;
  std::int32_t plane;
  /** \brief Of the plane there [m]. */
  double noise;
};

// The first plane among a voxel's neighbours, if half of them and three are on it.
std::optional<Filling>
planeAround (const VoxelGrid& grid, const BoundedPlanes& planes, std::size_t voxel)
{
  constexpr std::size_t fewest = 3;
  std::int32_t plane = no_plane;
  std::size_t on_it = 0;
  std::size_t all = 0;
  double noise = 0.0;
  for (const std::uint32_t neighbour : grid.neighbours[voxel]) {
    if (neighbour == voxel)
      continue;
    ++all;
    if (plane == no_plane)
      plane = planes.plane_of_voxel[neighbour];
    if (plane == no_plane || planes.plane_of_voxel[neighbour] != plane)
      continue;
    ++on_it;
    noise += planes.noise[neighbour];
  }
  if (on_it < fewest || 2 * on_it < all)
    return std::nullopt;
  return Filling{voxel, plane, noise / static_cast<double> (on_it)};
}

std::vector<Filling>
fillingsOf (const VoxelGrid& grid,
            const BoundedPlanes& planes,
            std::size_t begin,
            std::size_t end)
{
  constexpr double noises = 3.5;
  std::vector<Filling> fillings;
  for (std::size_t i = begin; i < end; ++i) {
    if (planes.plane_of_voxel[i] != no_plane)
      continue;
    const std::optional<Filling> filling = planeAround (grid, planes, i);
    if (!filling)
      continue;
    const Plane& plane = planes.planes[static_cast<std::size_t> (filling->plane)];
    const double limit = noises * filling->noise;
    if (meanSquaredDistance (grid.moments[i], plane) <= limit * limit)
      fillings.push_back (*filling);
  }
  return fillings;
}

} // namespace

void
fillHoles (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes)
{
  constexpr int widest_hole = 2;
  for (int round = 0; round < widest_hole; ++round)
    for (const std::vector<Filling>&piece : parallelPieces (
             threads, grid.size(), voxels_per_piece, [&] (auto begin, auto end) {
               return fillingsOf (grid, planes, begin, end);
             }))
      for (const Filling& filling : piece) {
        planes.plane_of_voxel[filling.voxel] = filling.plane;
        planes.noise[filling.voxel] = filling.noise;
      }
}

} // namespace pcl_ops::internal

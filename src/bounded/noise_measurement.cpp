// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/noise_measurement.h"

#include "bounded/noise_floors.h"
#include "voxels/voxel_traversal.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// Per voxel, a mean squared distance of points to their plane [m^2].
using Squares = std::vector<double>;

constexpr double unknown = -1.0;

Squares
squaresOfVoxels (const VoxelGrid& grid, unsigned threads, const BoundedPlanes& planes)
{
  Squares squares (grid.size(), unknown);
  forVoxels (grid, threads, [&] (std::size_t i) {
    if (const std::int32_t plane = planes.plane_of_voxel[i]; plane != no_plane)
      squares[i] = meanSquaredDistance (
          grid.moments[i], planes.planes[static_cast<std::size_t> (plane)]);
  });
  return squares;
}

std::vector<char>
innerVoxels (const VoxelGrid& grid, unsigned threads, const Labels& plane_of_voxel)
{
  std::vector<char> is_inner (grid.size(), 0);
  forVoxels (grid, threads, [&] (std::size_t i) {
    const VoxelRange& around = grid.neighbours[i];
    is_inner[i] =
        plane_of_voxel[i] != no_plane &&
        std::all_of (around.begin(), around.end(), [&] (std::uint32_t neighbour) {
          return plane_of_voxel[neighbour] == plane_of_voxel[i];
        });
  });
  return is_inner;
}

// Of inner voxels, with the inner ones around them.
Squares
squaresInside (const VoxelGrid& grid,
               unsigned threads,
               const Squares& of_voxels,
               const std::vector<char>& is_inner)
{
  Squares squares (grid.size(), unknown);
  forVoxels (grid, threads, [&] (std::size_t i) {
    if (!is_inner[i])
      return;
    double sum = 0.0;
    double points = 0.0;
    for (const std::uint32_t neighbour : grid.neighbours[i])
      if (is_inner[neighbour]) {
        sum += grid.moments[neighbour].count * of_voxels[neighbour];
        points += grid.moments[neighbour].count;
      }
    squares[i] = sum / points;
  });
  return squares;
}

// Hands squares on by a voxel to those of the same plane that have none.
Squares
handedOn (const VoxelGrid& grid,
          unsigned threads,
          const Labels& plane_of_voxel,
          const Squares& known)
{
  Squares squares = known;
  forVoxels (grid, threads, [&] (std::size_t i) {
    if (plane_of_voxel[i] == no_plane || known[i] != unknown)
      return;
    double sum = 0.0;
    double givers = 0.0;
    for (const std::uint32_t neighbour : grid.neighbours[i])
      if (known[neighbour] != unknown &&
          plane_of_voxel[neighbour] == plane_of_voxel[i]) {
        sum += known[neighbour];
        givers += 1.0;
      }
    if (givers > 0.0)
      squares[i] = sum / givers;
  });
  return squares;
}

// Of each plane the median over its inner voxels, over all for planes with next to
// none.
Squares
usualSquares (const BoundedPlanes& planes,
              const Squares& of_voxels,
              const std::vector<char>& is_inner)
{
  constexpr std::size_t fewest_inner = 3;
  std::vector<std::vector<float>> inner (planes.size());
  std::vector<std::vector<float>> all (planes.size());
  for (std::size_t i = 0; i < of_voxels.size(); ++i) {
    if (planes.plane_of_voxel[i] == no_plane)
      continue;
    const auto plane = static_cast<std::size_t> (planes.plane_of_voxel[i]);
    all[plane].push_back (static_cast<float> (of_voxels[i]));
    if (is_inner[i])
      inner[plane].push_back (static_cast<float> (of_voxels[i]));
  }
  Squares usual;
  for (std::size_t p = 0; p < planes.size(); ++p)
    usual.push_back (medianOf (inner[p].size() >= fewest_inner ? inner[p] : all[p]));
  return usual;
}

} // namespace

void
measureNoise (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes)
{
  constexpr int voxels_handed_on = 3;
  const Squares of_voxels = squaresOfVoxels (grid, threads, planes);
  const std::vector<char> is_inner = innerVoxels (grid, threads, planes.plane_of_voxel);
  Squares squares = squaresInside (grid, threads, of_voxels, is_inner);
  for (int i = 0; i < voxels_handed_on; ++i)
    squares = handedOn (grid, threads, planes.plane_of_voxel, squares);
  const Squares usual = usualSquares (planes, of_voxels, is_inner);
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (const std::int32_t plane = planes.plane_of_voxel[i]; plane != no_plane) {
      const double square =
          squares[i] != unknown ? squares[i] : usual[static_cast<std::size_t> (plane)];
      planes.noise[i] = std::max (std::sqrt (square), smallestNoise (grid));
    }
}

} // namespace pcl_ops::internal

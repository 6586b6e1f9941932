// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/plane_growing.h"

#include "bounded/noise_floors.h"
#include "voxels/voxel_traversal.h"

#include <algorithm>
#include <optional>

namespace pcl_ops::internal {

namespace {

// Largest rms distance of an adopted voxel in units of the noise next to it.
constexpr double noise_factor = 2.0;

struct Adoption {
  std::size_t voxel;
  std::int32_t plane;
  double noise;
};

// The plane next to a voxel that its points are nearest to, in units of the limit
// there.
std::optional<Adoption>
adoptingPlane (const VoxelGrid& grid,
               double limit,
               const BoundedPlanes& planes,
               std::size_t voxel)
{
  std::optional<Adoption> adoption;
  double best = 1.0;
  // Neighbours in a row mostly are on the same plane.
  std::optional<std::size_t> last;
  double squared = 0.0;
  forNeighboursOnPlanes (
      grid,
      planes.plane_of_voxel,
      voxel,
      [&] (std::size_t plane, std::size_t neighbour) {
        const double band = std::min (noise_factor * planes.noise[neighbour], limit);
        if (plane != last)
          squared = meanSquaredDistance (grid.moments[voxel], planes.planes[plane]);
        last = plane;
        const double ratio = squared / (band * band);
        if (ratio >= best)
          return;
        best = ratio;
        adoption = {voxel, static_cast<std::int32_t> (plane), planes.noise[neighbour]};
      });
  return adoption;
}

std::vector<Adoption>
adoptionsOf (const std::vector<std::size_t>& voxels,
             const VoxelGrid& grid,
             double limit,
             const BoundedPlanes& planes,
             unsigned threads)
{
  std::vector<Adoption> all;
  for (const std::vector<Adoption>&piece : parallelPieces (
           threads, voxels.size(), voxels_per_piece, [&] (auto begin, auto end) {
             std::vector<Adoption> adoptions;
             for (std::size_t i = begin; i < end; ++i)
               if (const auto adoption = adoptingPlane (grid, limit, planes, voxels[i]))
                 adoptions.push_back (*adoption);
             return adoptions;
           }))
    all.insert (all.end(), piece.begin(), piece.end());
  return all;
}

std::vector<std::size_t>
voxelsOffPlanes (const Labels& plane_of_voxel)
{
  std::vector<std::size_t> voxels;
  for (std::size_t i = 0; i < plane_of_voxel.size(); ++i)
    if (plane_of_voxel[i] == no_plane)
      voxels.push_back (i);
  return voxels;
}

// The voxels off planes that touch an adopted one, ascending.
std::vector<std::size_t>
voxelsNextTo (const VoxelGrid& grid,
              const std::vector<Adoption>& adoptions,
              const Labels& plane_of_voxel)
{
  std::vector<std::size_t> voxels;
  for (const Adoption& adoption : adoptions)
    for (const std::uint32_t neighbour : grid.neighbours[adoption.voxel])
      if (plane_of_voxel[neighbour] == no_plane)
        voxels.push_back (neighbour);
  std::sort (voxels.begin(), voxels.end());
  voxels.erase (std::unique (voxels.begin(), voxels.end()), voxels.end());
  return voxels;
}

} // namespace

void
growPlanes (const VoxelGrid& grid,
            std::optional<double> distance_threshold,
            unsigned threads,
            BoundedPlanes& planes)
{
  const double limit = distanceLimit (grid, distance_threshold);
  std::vector<std::size_t> border = voxelsOffPlanes (planes.plane_of_voxel);
  while (!border.empty()) {
    const std::vector<Adoption> adoptions =
        adoptionsOf (border, grid, limit, planes, threads);
    for (const Adoption& adoption : adoptions) {
      planes.plane_of_voxel[adoption.voxel] = adoption.plane;
      planes.noise[adoption.voxel] = adoption.noise;
    }
    border = voxelsNextTo (grid, adoptions, planes.plane_of_voxel);
  }
  refitPlanes (grid, planes);
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/noise_measurement.h"

#include "base/parallel.h"
#include "bounded/noise_floors.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

/** \brief What a voxel tells of its plane's noise. */
struct Distance {
  /** \brief Mean squared distance of its points to the plane [m^2]. */
  float squared = 0.0f;
  /** \brief Whether all voxels around are on the plane, too. */
  bool is_inside = false;
};

Distance
distanceOf (const VoxelGrid& grid, const BoundedPlanes& planes, std::size_t voxel)
{
  const std::int32_t plane = planes.plane_of_voxel[voxel];
  const VoxelRange& around = grid.neighbors[voxel];
  return {static_cast<float> (meanSquaredDistance (
              grid.moments[voxel], planes.planes[static_cast<std::size_t> (plane)])),
          std::all_of (around.begin(), around.end(), [&] (std::uint32_t neighbor) {
            return planes.plane_of_voxel[neighbor] == plane;
          })};
}

} // namespace

void
measureNoise (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes)
{
  constexpr std::size_t min_inside = 3;
  std::vector<Distance> distances (grid.size());
  forEach (threads, grid.size(), [&] (std::size_t i) {
    if (planes.plane_of_voxel[i] != no_plane)
      distances[i] = distanceOf (grid, planes, i);
  });
  std::vector<std::vector<float>> inside (planes.size());
  std::vector<std::vector<float>> all (planes.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes.plane_of_voxel[i] != no_plane) {
      const auto plane = static_cast<std::size_t> (planes.plane_of_voxel[i]);
      all[plane].push_back (distances[i].squared);
      if (distances[i].is_inside)
        inside[plane].push_back (distances[i].squared);
    }
  planes.noise.resize (planes.size(), smallestNoise (grid));
  for (std::size_t p = 0; p < planes.size(); ++p)
    if (!all[p].empty())
      planes.noise[p] =
          std::max (std::sqrt (static_cast<double> (medianOf (
                        inside[p].size() >= min_inside ? inside[p] : all[p]))),
                    smallestNoise (grid));
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/noise_measurement.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

void
measureNoise (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes)
{
  const auto planeOf = [&] (std::size_t voxel) {
    return static_cast<std::size_t> (planes.plane_of_voxel[voxel]);
  };
  std::vector<float> distances (grid.size());
  forEach (threads, grid.size(), [&] (std::size_t i) {
    if (planes.plane_of_voxel[i] != no_plane)
      distances[i] = static_cast<float> (
          meanSquaredDistance (grid.moments[i], planes.planes[planeOf (i)]));
  });
  std::vector<std::vector<float>> of_plane (planes.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes.plane_of_voxel[i] != no_plane)
      of_plane[planeOf (i)].push_back (distances[i]);
  planes.noise.resize (planes.size(), smallestNoise (grid));
  for (std::size_t p = 0; p < planes.size(); ++p)
    if (!of_plane[p].empty())
      planes.noise[p] =
          std::max (std::sqrt (static_cast<double> (medianOf (of_plane[p]))),
                    smallestNoise (grid));
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/voxel_grid.h"

#include <algorithm>
#include <optional>

namespace pcl_ops::internal {

/** \brief No noise is measured more finely than this [m]. */
inline double
smallestNoise (const VoxelGrid& grid)
{
  constexpr double share_of_a_voxel = 0.03;
  return share_of_a_voxel * grid.voxel_size;
}

/** \brief theta_h, or two voxels where there is none [m]. */
inline double
distanceLimit (const VoxelGrid& grid, std::optional<double> distance_threshold)
{
  constexpr double voxels = 2.0;
  return distance_threshold.value_or (voxels * grid.voxel_size);
}

/** \brief Distances below this always count as on the plane [m]. */
inline double
smallestBand (const VoxelGrid& grid, double limit)
{
  constexpr double share_of_a_voxel = 0.2;
  return std::min (limit, share_of_a_voxel * grid.voxel_size);
}

} // namespace pcl_ops::internal

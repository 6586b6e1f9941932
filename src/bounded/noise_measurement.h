// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief A voxel of fewer points does not tell the noise of its points. */
inline constexpr double min_points_of_noise = 16.0;

/** \brief No noise is measured more finely than this [m]. */
inline double
smallestNoise (const VoxelGrid& grid)
{
  constexpr double share_of_a_voxel = 0.03;
  return share_of_a_voxel * grid.voxel_size;
}

/** \brief Measures the noise of planes: the median of the rms distances of the points
 * of their voxels to the plane. At least \ref smallestNoise; a plane without voxels
 * here keeps its noise. */
void
measureNoise (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes);

} // namespace pcl_ops::internal

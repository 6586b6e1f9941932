// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief Measures the noise of planes: the median of the rms distances of the points
 * of their voxels to the plane. At least \ref smallestNoise.
 * \param[in] grid the voxels
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \param[in,out] planes whose noise is set; a plane without voxels here keeps its noise
 */
void
measureNoise (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes);

} // namespace pcl_ops::internal

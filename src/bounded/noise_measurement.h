// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief Measures the noise of each plane where it is alone, voxels all around which
 * are its own: the rms distance to the plane of the points there. Voxels at its
 * borders, whose points other surfaces reach into, get it from those next to them.
 * \param[in] grid the voxels
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \param[in,out] planes whose noise is set */
void
measureNoise (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief Gives voxels on no plane to the one that most of their neighbours are on, if
 * it explains their points with little more noise than there is around: what a clutter
 * of readings or a thin object left out of a plane. Twice, so that two voxels are
 * filled.
 * \param[in] grid the voxels
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \param[in,out] planes with their noise */
void
fillHoles (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"

namespace pcl_ops::internal {

/** \brief Voxel edge at which the points fill about \p wanted_voxels voxels.
 *
 * Counted on a few thousand points in voxels so large that they show all occupied ones,
 * and carried over to small voxels as for surfaces, whose occupied voxels grow with the
 * inverse square of the edge.
 * \return 0 for fewer than two different points */
double
voxelSizeFor (const Coordinates& positions, double wanted_voxels);

} // namespace pcl_ops::internal

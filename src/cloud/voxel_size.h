// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

namespace pcl_ops::internal {

/** \brief The nearest of 1, 1.1, ... 2, 2.25, ... 5, 6, ... 10 times a power of ten.
 *
 * What a size is estimated from differs a little where a cloud is given in other units
 * or rounded otherwise; voxels of the size as it is would divide it elsewhere. */
double
roundNumber (double size);

/** \brief Voxel edge at which the points fill about \p wanted_voxels voxels.
 *
 * Counted on a few thousand points in voxels so large that they show all occupied ones,
 * and carried over to small voxels as for surfaces, whose occupied voxels grow with the
 * inverse square of the edge.
 * \return a \ref roundNumber; 0 for fewer than two different points */
double
voxelSizeFor (const Coordinates& positions, double wanted_voxels);

} // namespace pcl_ops::internal

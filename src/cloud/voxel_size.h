// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

namespace pcl_ops::internal {

/** \brief Rounds a size above 0 to the nearest of 1, 1.1, ... 2, 2.25, ... 5, 6, ... 10
 * times a power of ten, which are 5 to 20 % apart.
 *
 * An estimated size changes a little if the same cloud is given in other units or with
 * other rounding. A rounded size mostly does not, and so the borders of voxels do not
 * move. */
double
roundNumber (double size);

/** \brief Estimates the voxel edge at which the points occupy about \p wanted_voxels
 * voxels.
 *
 * Counts the voxels that a sample of a few thousand points occupies, with voxels so
 * large that hardly any occupied one has no sampled point. Extrapolates to smaller
 * voxels as for surfaces, where the number of occupied voxels is proportional to 1 /
 * edge^2.
 * \param[in] points relative to an origin near most of them, as \ref Points are
 * \return the edge [m], rounded by \ref roundNumber; 0 if fewer than two different
 * points remain without outliers */
double
voxelSizeFor (const Coordinates& points, double wanted_voxels);

} // namespace pcl_ops::internal

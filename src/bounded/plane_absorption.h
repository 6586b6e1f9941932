// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief Gives planes to a larger neighbour that explains them: whose plane their
 * points are no farther from than a multiple of the noise on its side of the border. */
void
absorbPlanes (const VoxelGrid& grid, double noise_factor, BoundedPlanes& planes);

} // namespace pcl_ops::internal

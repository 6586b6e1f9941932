// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief Finds planes that go into a larger neighbor: their points are no farther from
 * it than a multiple of the noise of both.
 * \return for each plane the one that it ends in, itself if it stays */
Labels
absorbPlanes (const VoxelGrid& grid, double noise_factor, const BoundedPlanes& planes);

} // namespace pcl_ops::internal

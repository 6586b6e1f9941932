// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief Finds planes that go into a larger neighbor: one plane for both is no farther
 * from the points of either than a multiple of the noise there.
 * \param[in] grid the voxels
 * \param[in] noise_factor that multiple
 * \param[in] planes with their noise
 * \return for each plane the one that it ends in, itself if it stays */
Labels
absorbPlanes (const VoxelGrid& grid, double noise_factor, const BoundedPlanes& planes);

} // namespace pcl_ops::internal

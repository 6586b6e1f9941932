// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief Finds the planes that larger planes absorb. The larger plane has more points
 * and touches the smaller one: they have adjacent voxels. The rms distance of the
 * points of the smaller plane to the larger one has to be below \p noise_factor times
 * the larger plane's rms. The rms of a plane here is the rms distance of its points to
 * itself, at least its noise; that of the larger plane is limited to other_noise_ratio
 * (noise_ratios.h) times that of the smaller one.
 * \param[in] planes with their noise
 * \return for each plane the plane that finally absorbs it; itself if none does */
Labels
absorbPlanes (const VoxelGrid& grid, double noise_factor, const BoundedPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/bounded_planes.h"

#include <optional>

namespace pcl_ops::internal {

/** \brief Largest rms distance of a voxel's points to the plane the voxel goes to, in
 * units of that plane's noise: surfaces meet in voxels at its border. */
constexpr double noises_of_a_voxel = 3.0;

/** \brief Lets planes grow, voxel by voxel: of the voxels without a plane, each goes to
 * that of the planes next to it which its points are nearest to, in units of the
 * plane's noise; up to \ref noises_of_a_voxel.
 * \param[in] distance_threshold theta_h: largest rms distance [m], if any
 * \param[in,out] planes with their noise; refitted to their voxels */
void
growPlanes (const VoxelGrid& grid,
            std::optional<double> distance_threshold,
            unsigned threads,
            BoundedPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/bounded_planes.h"

#include <optional>

namespace pcl_ops::internal {

/** \brief Largest rms distance of a voxel's points to the plane that takes the voxel,
 * in units of the plane's noise. Voxels at the border of a plane have a larger rms
 * distance if many of their points are on a second surface. Chosen by hand;
 * src/doc/constants.csv has F with 5. */
constexpr double max_voxel_rms_in_noises = 3.0;

/** \brief Grows planes voxel by voxel until no voxel without a plane fits the plane of
 * a neighbor. Of several planes a voxel goes to the one with the least ratio of the rms
 * distance of its points to the largest rms distance allowed: \ref
 * max_voxel_rms_in_noises times the noise of the plane.
 * \param[in] distance_threshold theta_h: upper bound of the rms distance [m], if given
 * \param[in,out] planes with their noise, which stays as it is; the planes are refitted
 * to their points in the end */
void
growPlanes (const VoxelGrid& grid,
            std::optional<double> distance_threshold,
            unsigned threads,
            BoundedPlanes& planes);

} // namespace pcl_ops::internal

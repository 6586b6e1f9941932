// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/plane_assignment.h"
#include "voxels/bounded_planes.h"

#include <optional>

namespace pcl_ops::internal {

/** \brief Assigns points to bounded planes: to the likeliest of the planes whose
 * support has a voxel within one voxel of the point, see \ref likeliestOf.
 * \param[in] distance_threshold largest distance of a point to its plane [m]; not given:
 * the noise alone limits it, and where a voxel fits the only plane nearby, all its
 * points are on it
 * \param[in] noise_factor largest distance in units of the plane's noise
 * \param[in] is_left_out voxels whose points stay as they are; empty: none
 * \param[in,out] assigned labels of points, which are overwritten but for voxels left out
 * or without a plane nearby, and the moments of each plane, to which points are added
 */
void
assignToBoundedPlanes (const Coordinates& points,
                       const VoxelGrid& grid,
                       const BoundedPlanes& planes,
                       std::optional<double> distance_threshold,
                       double noise_factor,
                       unsigned threads,
                       const std::vector<char>& is_left_out,
                       AssignedPoints& assigned);

} // namespace pcl_ops::internal

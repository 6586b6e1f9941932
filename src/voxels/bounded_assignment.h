// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/plane_assignment.h"
#include "voxels/bounded_planes.h"

#include <optional>

namespace pcl_ops::internal {

/** \brief Assigns points to bounded planes: to the likeliest of the planes whose
 * support has a voxel within one voxel of the point, see \ref likeliestOf.
 * \param[in] noise_factor largest distance in units of the plane's noise
 * \param[in] is_left_out voxels whose points stay as they are; empty: none
 * \param[in,out] assigned labels of all points, and the moments of each plane's, which
 * are added */
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

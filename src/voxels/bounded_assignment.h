// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/plane_assignment.h"
#include "voxels/bounded_planes.h"

#include <optional>

namespace pcl_ops::internal {

/** \brief Assigns each point to the likeliest plane (\ref likeliestOf) among the planes
 * of its voxel and of the neighbors of its voxel.
 * \param[in] distance_threshold largest distance of a point to its plane [m]. If it is
 * not given, the noise alone limits the distance, and a voxel that fits the only plane
 * around it gives all its points to this plane
 * \param[in] noise_factor largest distance of a point to its plane in units of the
 * plane's noise
 * \param[in] is_left_out not 0 for voxels whose points keep their labels; empty: none
 * \param[in,out] assigned its labels must have an entry for each point. They are
 * overwritten, except those of points in voxels that are left out or have no plane
 * around. Its moments are resized to the number of planes. Points are added to the
 * moments of their planes */
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

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include "cloud/voxel_grid.h"
#include "detection/plane_assignment.h"
#include "voxels/sparse_points.h"

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Extends planes to sparse points, as lidar rings on the ground are. A point on
 * no plane goes to the likeliest plane (\ref likeliestOf) in larger voxels around it,
 * first in those of twice the edge. Planes narrower than these voxels are not extended.
 * \param[in] open points on no plane in sparse voxels, voxel after voxel
 * \param[in] grid with neighbors and larger voxels, by \ref connect
 * \param[in] doublings how many times the edge is doubled; fewer if one voxel holds
 * all points before
 * \param[in] distance_threshold theta_h: largest distance of a point to its plane [m],
 * if given; like_noise_ratio (1.5) times the plane's noise limits the distance in any
 * case
 * \param[in,out] assigned labels of all points, and moments of each plane; points that
 * get a plane are added to both */
void
extendPlanes (const Coordinates& points,
              const VoxelGrid& grid,
              std::vector<OpenPoint> open,
              int doublings,
              std::optional<double> distance_threshold,
              AssignedPoints& assigned);

} // namespace pcl_ops::internal

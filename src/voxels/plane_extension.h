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

/** \brief Lets planes go on where points are sparse, as the rings of a lidar on the
 * ground are: a point on no plane goes to the likeliest of the planes in the larger
 * voxels around, first in those of twice the edge; planes as wide as these voxels.
 * \param[in] open those on no plane where points are sparse, voxel after voxel
 * \param[in] levels how many times the edge is doubled
 * \param[in,out] assigned labels of all points, and the moments of each plane's, which
 * the new ones are added to */
void
extendPlanes (const Coordinates& points,
              const VoxelGrid& grid,
              std::vector<OpenPoint> open,
              int levels,
              std::optional<double> distance_threshold,
              AssignedPoints& assigned);

} // namespace pcl_ops::internal

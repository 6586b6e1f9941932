// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"
#include "voxels/voxel_grid.h"
#include <pcl_ops/plane_merging.h>

namespace pcl_ops::internal {

/** \brief The points on no plane whose voxels, with those around, hold too few points
 * to tell: where a cloud is far sparser than in most of its voxels, another voxel size
 * does it justice.
 * \param[in] grid voxels with their neighbours
 * \param[in] order numbers of all points, voxel after voxel
 * \param[in] labels plane of each point, or no_plane
 * \param[in] least_points fewest points of voxels that can tell
 * \return them, or none where they are not a cloud of their own: less than a hundredth
 * of all points, or more than half, whose voxels these are */
Indices
sparsePoints (const VoxelGrid& grid,
              const Indices& order,
              const Labels& labels,
              double least_points);

} // namespace pcl_ops::internal

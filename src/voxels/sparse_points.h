// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include "cloud/voxel_grid.h"
#include "detection/plane_assignment.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief The voxels that hold, with those around, too few points to tell: where a
 * cloud is far sparser than in most of its voxels.
 * \param[in] min_points fewest points of voxels that can tell
 * \return them, or none where they hold less than a hundredth of the points */
Indices
sparseVoxels (const VoxelGrid& grid, double min_points);

/** \brief A point on no plane, and the voxel that it is in. */
struct OpenPoint {
  std::uint32_t point;
  std::uint32_t voxel;
};

/** \brief The points on no plane in some voxels, voxel after voxel. */
std::vector<OpenPoint>
openPoints (const VoxelGrid& grid, const Indices& voxels, const Labels& labels);

/** \brief The points, ascending, that another voxel size does justice.
 * \param[in] open those of \ref sparseVoxels
 * \return none where they are not a cloud of their own: less than a hundredth of all
 * points, or more than half, whose voxels these are */
Indices
sparsePoints (const std::vector<OpenPoint>& open, std::size_t all);

/** \brief Takes planes from sparse points that scatter far more than those of the dense
 * ones, and a quarter as far or more as they are from each other: voxels as large as
 * sparse points need make a plane of any mist.
 * \param[in,out] sparse points with their planes; moments of rejected ones are empty */
void
rejectMist (const std::vector<Moments>& dense,
            unsigned threads,
            AssignedPoints& sparse);

} // namespace pcl_ops::internal

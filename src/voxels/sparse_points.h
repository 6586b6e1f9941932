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

/** \brief The voxels that have, together with their neighbors, fewer than \p min_points
 * points.
 * \return their indices; empty if they have fewer than a hundredth of all points */
Indices
sparseVoxels (const VoxelGrid& grid, double min_points);

/** \brief Indices of a point on no plane and of the voxel that it is in. */
struct OpenPoint {
  std::uint32_t point;
  std::uint32_t voxel;
};

/** \brief The points on no plane in the given voxels, voxel after voxel. */
std::vector<OpenPoint>
openPoints (const VoxelGrid& grid, const Indices& voxels, const Labels& labels);

/** \brief The points among which to detect planes anew, with a voxel size of their own.
 * \param[in] open points on no plane in the \ref sparseVoxels
 * \param[in] cloud_size number of points of the cloud
 * \return indices, ascending; empty for fewer than a hundredth of all points, and for
 * more than half of them: the voxel size, chosen for the whole cloud, already suits so
 * many */
Indices
sparsePoints (const std::vector<OpenPoint>& open, std::size_t cloud_size);

/** \brief Rejects planes of sparse points that are only a mist: points without a
 * surface, in which a search finds planes because sparse points need large voxels. A
 * plane is a mist if the rms distance of its points is above \ref other_noise_ratio (6)
 * times that of the points of dense planes, and above a quarter of the spacing of its
 * points.
 * \param[in] dense moments of the other planes; no plane is rejected if there are none
 * \param[in,out] sparse a rejected plane gets empty moments, its points get no_plane */
void
rejectMist (const std::vector<Moments>& dense,
            unsigned threads,
            AssignedPoints& sparse);

} // namespace pcl_ops::internal

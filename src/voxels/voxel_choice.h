// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include "cloud/voxel_grid.h"

namespace pcl_ops::internal {

/** \brief How many voxels to divide a cloud into. Smaller planes need more voxels, but
 * noise does not shrink with the voxels: so their number grows with the cube root of
 * the number of points, as measured in rooms of 50 thousand to 3 million points.
 * \param[in] sampling_rate alpha_s, which the number of voxels grows with
 * \param[in] min_points_per_voxel fewest points of a voxel on average: this limits the
 * number of voxels */
double
wantedVoxels (std::size_t points, double sampling_rate, double min_points_per_voxel);

/** \brief Spacing of single-precision numbers at the largest coordinate of the cloud's
 * origin [m]: half a meter for northings of UTM. In voxels no larger than such a step
 * rounded coordinates look like planes. */
double
singlePrecisionStep (const Points& points);

/** \brief Divides a cloud into voxels as large as its noise asks and its points allow.
 * \param[in] sampling_rate alpha_s, which the number of voxels grows with
 * \return empty grids for fewer than two different points */
VoxelLevels
voxelizeByNoise (const Points& points, double sampling_rate, unsigned threads);

double
meanPointsPerVoxel (const VoxelGrid& grid);

} // namespace pcl_ops::internal

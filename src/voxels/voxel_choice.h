// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include "cloud/voxel_grid.h"

namespace pcl_ops::internal {

/** \brief How many voxels to divide a cloud of so many points into. Smaller planes need
 * more voxels, but noise does not shrink with the voxels: so the number of voxels grows
 * with the cube root of the number of points, as measured in rooms of 50 thousand to 3
 * million points.
 * \param[in] sampling_rate alpha_s: the number of voxels is proportional to it
 * \param[in] min_points_per_voxel on average: this limits the number of voxels */
double
wantedVoxels (std::size_t points, double sampling_rate, double min_points_per_voxel);

/** \brief Distance from the largest coordinate of the cloud's origin to the next
 * single-precision number [m]: half a meter for northings of UTM. If coordinates were
 * once rounded to single precision, these steps look like planes in voxels of about
 * their size. */
double
singlePrecisionStep (const Points& points);

/** \brief Divides a cloud into voxels as large as its noise asks and its points allow.
 * \param[in] sampling_rate as for \ref wantedVoxels
 * \return empty grids for fewer than two different points */
VoxelLevels
voxelizeByNoise (const Points& points, double sampling_rate, unsigned threads);

/** \brief Mean number of points in a voxel; NaN for an empty grid. */
double
meanPointsPerVoxel (const VoxelGrid& grid);

} // namespace pcl_ops::internal

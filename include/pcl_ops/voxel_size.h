// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>

namespace pcl_ops {

/** \brief Returns the voxel size with which a cloud has about \p wanted_voxels occupied
 * voxels, rounded to few digits. It is for clouds that are searched in tiles.
 * \param[in] points a thousand finite points or more, a uniform sample of the cloud,
 * shifted so that the origin is near most of them
 * \param[in] wanted_voxels occupied voxels of the whole cloud, above 0
 * \return edge of a voxel [m]; 0 if there are no points, or if all or most of them are
 * at one position */
PCL_OPS_EXPORT double
voxelSizeFor (const CloudView& points, double wanted_voxels);

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>

namespace pcl_ops {

/** \brief A voxel_size for tiles of a cloud: the edge at which all its points fill
 * about \p wanted_voxels voxels, from their density where they are.
 * \param[in] points some thousand finite ones or more, spread evenly over the cloud;
 * zero is near most of them
 * \param[in] wanted_voxels of the whole cloud
 * \return [m]; 0 for fewer than two different points */
PCL_OPS_EXPORT double
voxelSizeFor (const CloudView& points, double wanted_voxels);

} // namespace pcl_ops

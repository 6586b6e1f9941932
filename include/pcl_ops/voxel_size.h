// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>

namespace pcl_ops {

/** \brief The voxel size at which a cloud has about \p wanted_voxels voxels with
 * points, a round number, for tiles of the cloud.
 * \param[in] points some thousand finite ones or more, spread evenly over the cloud;
 * shifted so that zero is among them
 * \param[in] wanted_voxels of the whole cloud, above 0
 * \return [m]; 0 for fewer than two different points */
PCL_OPS_EXPORT double
voxelSizeFor (const CloudView& points, double wanted_voxels);

} // namespace pcl_ops

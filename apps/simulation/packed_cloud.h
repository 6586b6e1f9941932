// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <io/cloud_file.h>

namespace pcl_ops::simulation {

/** \brief The cloud as a file has it, without the padding of pcl::PointXYZL. */
apps::FileCloud
packedCloud (const pcl::PointCloud<pcl::PointXYZL>& cloud);

} // namespace pcl_ops::simulation

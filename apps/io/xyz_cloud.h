// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_ops::apps {

/** \brief What planes are looked for in: coordinates alone, in single
 * precision. */
using XyzCloud = pcl::PointCloud<pcl::PointXYZ>;

} // namespace pcl_ops::apps

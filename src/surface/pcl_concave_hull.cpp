// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/surface/impl/concave_hull.hpp>
#include <pcl/point_types.h>

// In libpcl_surface, too, but that library loads 18 others of VTK.
template class pcl::ConcaveHull<pcl::PointXYZ>;

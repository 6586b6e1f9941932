// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

#include <pcl_ops/impl/grid_search.hpp>

// Compiles GridSearch for the point types that PCL was built for.
#ifndef PCL_NO_PRECOMPILE
#ifdef PCL_ONLY_CORE_POINT_TYPES
PCL_INSTANTIATE (
    GridSearch, (pcl::PointXYZ) (pcl::PointXYZI) (pcl::PointXYZRGBA) (pcl::PointXYZRGB))
#else
PCL_INSTANTIATE (GridSearch, PCL_XYZ_POINT_TYPES)
#endif
#endif

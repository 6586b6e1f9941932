// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

#include <pcl_ops/impl/plane_detector.hpp>

#ifndef PCL_NO_PRECOMPILE
#ifdef PCL_ONLY_CORE_POINT_TYPES
#define PCL_OPS_POINT_TYPES                                                            \
  (pcl::PointXYZ) (pcl::PointXYZI) (pcl::PointXYZRGBA) (pcl::PointXYZRGB)
#else
#define PCL_OPS_POINT_TYPES PCL_XYZ_POINT_TYPES
#endif
PCL_INSTANTIATE (PlaneDetector, PCL_OPS_POINT_TYPES)
#endif

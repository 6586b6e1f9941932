// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/impl/plane_detector.hpp>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#ifndef PCL_NO_PRECOMPILE
#ifdef PCL_ONLY_CORE_POINT_TYPES
#define PCL_OPS_POINT_TYPES                                                            \
  (pcl::PointXYZ) (pcl::PointXYZI) (pcl::PointXYZRGBA) (pcl::PointXYZRGB)
#else
#define PCL_OPS_POINT_TYPES PCL_XYZ_POINT_TYPES
#endif
PCL_INSTANTIATE (OrientedPointSampling, PCL_OPS_POINT_TYPES)
PCL_INSTANTIATE (FastSamplingPlaneFiltering, PCL_OPS_POINT_TYPES)
PCL_INSTANTIATE (KernelHoughTransform, PCL_OPS_POINT_TYPES)
#endif

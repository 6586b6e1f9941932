// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

#include <pcl_ops/impl/sac_model_oriented_point.hpp>
// With only its core point types PCL does not instantiate its plane model for point
// types with normals.
#ifdef PCL_ONLY_CORE_POINT_TYPES
#include <pcl/sample_consensus/impl/sac_model_plane.hpp>
#endif

// Compiles the template for PCL's point types with normals.
#ifndef PCL_NO_PRECOMPILE
PCL_INSTANTIATE (SampleConsensusModelOrientedPoint,
                 (pcl::PointNormal) (pcl::PointXYZRGBNormal) (pcl::PointXYZINormal) (
                     pcl::PointXYZLNormal) (pcl::PointSurfel))
#endif

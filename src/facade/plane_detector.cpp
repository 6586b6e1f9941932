// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/console/print.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>

#include <pcl_ops/impl/plane_detector.hpp>

#include <exception>

namespace pcl_ops::detail {

void
toModels (std::vector<PlaneSegment>& planes,
          const pcl::PCLHeader& header,
          std::vector<pcl::ModelCoefficients>& coefficients,
          std::vector<pcl::PointIndices>& inliers)
{
  coefficients.assign (planes.size(), pcl::ModelCoefficients());
  inliers.assign (planes.size(), pcl::PointIndices());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane plane = planes[i].plane();
    coefficients[i].header = inliers[i].header = header;
    coefficients[i].values = {static_cast<float> (plane.normal.x()),
                              static_cast<float> (plane.normal.y()),
                              static_cast<float> (plane.normal.z()),
                              static_cast<float> (plane.offset)};
    inliers[i].indices.swap (planes[i].inliers);
  }
}

bool
runAndReport (const std::string& class_name, const std::function<void()>& detect)
{
  try {
    detect();
    return true;
  }
  catch (const std::exception& error) {
    PCL_ERROR ("[pcl_ops::%s::segment] %s\n", class_name.c_str(), error.what());
    return false;
  }
  catch (...) { // from functions of the user
    PCL_ERROR ("[pcl_ops::%s::segment] an unknown exception\n", class_name.c_str());
    return false;
  }
}

} // namespace pcl_ops::detail

// Compiles the functions of the header above that depend on the point type, for the
// point types that PCL was built for.
#ifndef PCL_NO_PRECOMPILE
#ifdef PCL_ONLY_CORE_POINT_TYPES
PCL_INSTANTIATE (
    PlaneDetector,
    (pcl::PointXYZ) (pcl::PointXYZI) (pcl::PointXYZRGBA) (pcl::PointXYZRGB))
#else
PCL_INSTANTIATE (PlaneDetector, PCL_XYZ_POINT_TYPES)
#endif
#endif

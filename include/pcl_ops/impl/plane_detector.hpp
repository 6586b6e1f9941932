// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_extent.h>

namespace pcl_ops::detail {

template <typename PointT>
DetectorInput
detectorInput (const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
               const pcl::Indices* indices,
               const typename pcl::search::Search<PointT>::Ptr& search,
               unsigned threads)
{
  DetectorInput input{CloudView (*cloud),
                      indices,
                      cloud->sensor_origin_.template head<3>().template cast<double>(),
                      nullptr};
  if (!search)
    return input;
  input.search_over = [cloud, search, threads] (const pcl::Indices& finite) {
    search->setInputCloud (
        cloud,
        finite.empty() ? nullptr : pcl::make_shared<const pcl::Indices> (finite));
    const auto nearest = [=] (pcl::index_t point,
                              int k,
                              pcl::Indices& neighbors,
                              std::vector<float>& squared_distances) {
      search->nearestKSearch ((*cloud)[point], k, neighbors, squared_distances);
      checkNeighbors (neighbors, cloud->size());
    };
    const auto within = [=] (pcl::index_t point,
                             double radius,
                             pcl::Indices& neighbors,
                             std::vector<float>& squared_distances) {
      search->radiusSearch ((*cloud)[point], radius, neighbors, squared_distances);
      checkNeighbors (neighbors, cloud->size());
    };
    // Only GridSearch and pcl::search::KdTree are known to be thread-safe.
    const std::string& name = search->getName();
    const bool is_safe = name == "GridSearch" || name == "KdTree";
    return NeighborSearch{nearest, within, is_safe ? threads : 1};
  };
  return input;
}

template <typename PointT>
void
toRegions (const pcl::PointCloud<PointT>& cloud,
           const std::vector<PlaneSegment>& planes,
           PlanarRegions<PointT>& regions)
{
  regions.clear();
  for (const PlaneSegment& segment : planes) {
    typename pcl::PointCloud<PointT>::VectorType contour;
    for (const Eigen::Vector3d& corner : planeExtent (cloud, segment).hull) {
      PointT point{};
      point.x = static_cast<float> (corner.x());
      point.y = static_cast<float> (corner.y());
      point.z = static_cast<float> (corner.z());
      contour.push_back (point);
    }
    const Plane plane = segment.plane();
    Eigen::Vector4f coefficients;
    coefficients << plane.normal.cast<float>(), static_cast<float> (plane.offset);
    regions.emplace_back (segment.centroid.cast<float>(),
                          segment.moments.covariance().template cast<float>(),
                          static_cast<unsigned> (segment.inliers.size()),
                          contour,
                          coefficients);
  }
}

} // namespace pcl_ops::detail

// Compiles the functions that depend only on the point type, for the type T. The
// detector classes (54: three for each of 18 point types), with 30 to 40 short
// functions each, are instantiated where they are used.
#define PCL_INSTANTIATE_PlaneDetector(T)                                               \
  template PCL_OPS_EXPORT pcl_ops::detail::DetectorInput                               \
  pcl_ops::detail::detectorInput<T> (const pcl::PointCloud<T>::ConstPtr&,              \
                                     const pcl::Indices*,                              \
                                     const pcl::search::Search<T>::Ptr&,               \
                                     unsigned);                                        \
  template PCL_OPS_EXPORT void pcl_ops::detail::toRegions (                            \
      const pcl::PointCloud<T>&,                                                       \
      const std::vector<pcl_ops::PlaneSegment>&,                                       \
      pcl_ops::detail::PlanarRegions<T>&);

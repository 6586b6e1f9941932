// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

namespace pcl_ops {

template <typename PointT>
PlanarPoints
pointsOnPlane (const pcl::PointCloud<PointT>& cloud,
               const PlaneSegment& plane,
               const PlaneFrame& frame)
{
  PlanarPoints points;
  points.reserve (plane.inliers.size());
  for (const pcl::index_t index : plane.inliers) {
    const PointT& point = cloud[index];
    points.push_back (frame.toPlane (Eigen::Vector3d (point.x, point.y, point.z)));
  }
  return points;
}

template <typename PointT>
PlaneExtent
planeExtent (const pcl::PointCloud<PointT>& cloud, const PlaneSegment& plane)
{
  const PlaneFrame frame (plane.centroid, plane.normal);
  const PlanarPoints points = pointsOnPlane (cloud, plane, frame);
  return extentOf (convexHull (points), points, frame);
}

} // namespace pcl_ops

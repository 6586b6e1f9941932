// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/points.h>

namespace pcl_ops {

template <typename PointT>
Points
finitePoints (const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices)
{
  Points points;
  points.x.reserve (indices.size ());
  points.y.reserve (indices.size ());
  points.z.reserve (indices.size ());
  points.index.reserve (indices.size ());
  for (const pcl::index_t i : indices) {
    const PointT& point = cloud[i];
    if (!(std::isfinite (point.x) && std::isfinite (point.y) && std::isfinite (point.z)))
      continue;
    if (points.index.empty ())
      points.origin = Eigen::Vector3d (point.x, point.y, point.z);
    points.add (static_cast<float> (point.x - points.origin.x ()),
                static_cast<float> (point.y - points.origin.y ()),
                static_cast<float> (point.z - points.origin.z ()));
    points.index.push_back (i);
  }
  return points;
}

} // namespace pcl_ops

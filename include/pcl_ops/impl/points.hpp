// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/points.h>

#include <array>

namespace pcl_ops {

/** \brief The median of some of the points: near most of them, wherever a few stray to.
 * \return zero for no points */
template <typename PointT>
Eigen::Vector3d
medianPosition (const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices)
{
  constexpr std::size_t looked_at = 100;
  const std::size_t stride = indices.size () / looked_at + 1;
  std::array<std::vector<float>, 3> values;
  for (std::size_t i = 0; i < indices.size (); i += stride) {
    values[0].push_back (cloud[indices[i]].x);
    values[1].push_back (cloud[indices[i]].y);
    values[2].push_back (cloud[indices[i]].z);
  }
  return {medianOf (values[0]), medianOf (values[1]), medianOf (values[2])};
}

template <typename PointT>
Points
finitePoints (const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices)
{
  Points points;
  points.index.reserve (indices.size ());
  for (const pcl::index_t i : indices)
    if (const PointT& point = cloud[i];
        std::isfinite (point.x) && std::isfinite (point.y) && std::isfinite (point.z))
      points.index.push_back (i);
  sortOnce (points.index);
  points.origin = medianPosition (cloud, points.index);
  points.resize (points.index.size ());
  for (std::size_t i = 0; i < points.size (); ++i) {
    const PointT& point = cloud[points.index[i]];
    points.x[i] = static_cast<float> (point.x - points.origin.x ());
    points.y[i] = static_cast<float> (point.y - points.origin.y ());
    points.z[i] = static_cast<float> (point.z - points.origin.z ());
  }
  return points;
}

} // namespace pcl_ops

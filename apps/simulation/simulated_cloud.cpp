// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_cloud.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl_ops::simulation {

SimulatedCloud
labeledBySize (LabeledCloud cloud, const std::vector<Plane>& surfaces)
{
  SimulatedCloud result{std::move (cloud), {}};
  std::vector<std::size_t> counts (surfaces.size() + 1, 0);
  for (const auto& point : result.cloud)
    ++counts[point.label];
  std::vector<SurfaceId> by_size (surfaces.size());
  std::iota (by_size.begin(), by_size.end(), SurfaceId (1));
  std::stable_sort (by_size.begin(), by_size.end(), [&counts] (auto a, auto b) {
    return counts[a] > counts[b];
  });
  std::vector<std::uint32_t> label_of (surfaces.size() + 1, 0);
  for (const SurfaceId surface : by_size)
    if (counts[surface] >= min_points_of_plane) {
      result.planes.push_back (surfaces[surface - 1]);
      label_of[surface] = std::uint32_t (result.planes.size());
    }
  for (auto& point : result.cloud)
    point.label = label_of[point.label];
  return result;
}

pcl::PointXYZL
pointAt (const Eigen::Vector3d& position, SurfaceId surface)
{
  pcl::PointXYZL point;
  point.getVector3fMap() = position.cast<float>();
  point.label = surface;
  return point;
}

LabeledCloud
toSurfaceCloud (const Scan& scan, const Eigen::Isometry3d& pose, bool organized)
{
  LabeledCloud cloud;
  cloud.reserve (scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const std::size_t ray = organized && scan.column_by_column
                                ? i % scan.columns * scan.rows + i / scan.columns
                                : i;
    if (std::isfinite (scan.points[ray].x()))
      cloud.push_back (pointAt (pose * scan.points[ray], scan.surfaces[ray]));
    else if (organized)
      cloud.push_back (pointAt (Eigen::Vector3d::Constant (std::nan ("")), no_surface));
  }
  if (organized) {
    cloud.width = std::uint32_t (scan.columns);
    cloud.height = std::uint32_t (scan.rows);
    cloud.is_dense = false;
  }
  cloud.sensor_origin_.head<3>() = pose.translation().cast<float>();
  cloud.sensor_orientation_ = Eigen::Quaterniond (pose.linear()).cast<float>();
  return cloud;
}

} // namespace pcl_ops::simulation

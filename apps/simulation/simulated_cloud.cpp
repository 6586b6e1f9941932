// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl_ops::simulation {

std::vector<LabeledPlane>
labelBySize (pcl::PointCloud<pcl::PointXYZL>& cloud, const std::vector<Plane>& surfaces)
{
  std::vector<std::size_t> counts (surfaces.size() + 1, 0);
  for (const auto& point : cloud)
    ++counts[point.label];
  std::vector<SurfaceId> by_size (surfaces.size());
  std::iota (by_size.begin(), by_size.end(), SurfaceId (1));
  std::stable_sort (by_size.begin(), by_size.end(), [&counts] (auto a, auto b) {
    return counts[a] > counts[b];
  });
  std::vector<LabeledPlane> planes;
  std::vector<std::uint32_t> label_of (surfaces.size() + 1, 0);
  for (const SurfaceId surface : by_size) {
    if (counts[surface] < min_points_of_plane)
      break;
    label_of[surface] = std::uint32_t (planes.size() + 1);
    planes.push_back ({label_of[surface], surfaces[surface - 1], counts[surface]});
  }
  for (auto& point : cloud)
    point.label = label_of[point.label];
  return planes;
}

pcl::PointCloud<pcl::PointXYZL>
toSurfaceCloud (const Scan& scan, const Eigen::Isometry3d& pose, CloudLayout layout)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const bool organized = layout == CloudLayout::Organized;
  pcl::PointCloud<pcl::PointXYZL> cloud;
  cloud.reserve (scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const std::size_t ray = organized && scan.column_by_column
                                ? i % scan.columns * scan.rows + i / scan.columns
                                : i;
    if (std::isfinite (scan.points[ray].x()))
      cloud.push_back (pointAt (pose * scan.points[ray], scan.surfaces[ray]));
    else if (organized)
      cloud.push_back (pointAt (Eigen::Vector3d::Constant (nan), no_surface));
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

SimulatedCloud
toCloud (const Scan& scan,
         const Eigen::Isometry3d& pose,
         const Scene& scene,
         CloudLayout layout)
{
  SimulatedCloud simulated{toSurfaceCloud (scan, pose, layout), {}};
  simulated.planes = labelBySize (simulated.cloud, surfacePlanes (scene));
  return simulated;
}

} // namespace pcl_ops::simulation

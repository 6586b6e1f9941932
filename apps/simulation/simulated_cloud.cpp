// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl_ops::simulation {

namespace {

pcl::PointXYZL
pointAt (const Eigen::Vector3d& position, SurfaceId surface)
{
  pcl::PointXYZL point;
  point.getVector3fMap() = position.cast<float>();
  point.label = surface;
  return point;
}

pcl::PointXYZL
missingPoint ()
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return pointAt (Eigen::Vector3d::Constant (nan), no_surface);
}

void
setSensorPose (pcl::PointCloud<pcl::PointXYZL>& cloud, const Eigen::Isometry3d& pose)
{
  cloud.sensor_origin_.head<3>() = pose.translation().cast<float>();
  cloud.sensor_origin_.w() = 0.0f;
  cloud.sensor_orientation_ = Eigen::Quaterniond (pose.linear()).cast<float>();
}

std::vector<std::size_t>
countPoints (const pcl::PointCloud<pcl::PointXYZL>& cloud, std::size_t surfaces)
{
  std::vector<std::size_t> counts (surfaces + 1, 0);
  for (const auto& point : cloud)
    ++counts[point.label];
  return counts;
}

} // namespace

pcl::PointCloud<pcl::PointXYZL>
toSurfaceCloud (const DepthImage& image, const DepthCamera& camera, CloudLayout layout)
{
  pcl::PointCloud<pcl::PointXYZL> cloud;
  cloud.reserve (image.depth.size());
  for (std::size_t i = 0; i < image.depth.size(); ++i) {
    const std::size_t row = i / image.width;
    const auto ray = camera.ray (double (i % image.width), double (row));
    if (std::isfinite (image.depth[i]))
      cloud.push_back (
          pointAt (camera.pose * (image.depth[i] * ray), image.surface[i]));
    else if (layout == CloudLayout::Organized)
      cloud.push_back (missingPoint());
  }
  if (layout == CloudLayout::Organized) {
    cloud.width = std::uint32_t (image.width);
    cloud.height = std::uint32_t (image.height);
    cloud.is_dense = false;
  }
  setSensorPose (cloud, camera.pose);
  return cloud;
}

SimulatedCloud
toCloud (const DepthImage& image,
         const DepthCamera& camera,
         const Scene& scene,
         CloudLayout layout)
{
  SimulatedCloud simulated{toSurfaceCloud (image, camera, layout), {}};
  simulated.planes = labelBySize (simulated.cloud, surfacePlanes (scene));
  return simulated;
}

pcl::PointCloud<pcl::PointXYZL>
toSurfaceCloud (const LidarScan& scan,
                const Eigen::Isometry3d& pose,
                CloudLayout layout)
{
  const bool organized = layout == CloudLayout::Organized;
  const std::size_t rays = scan.points.size();
  const std::size_t steps = rays / std::size_t (scan.beams);
  pcl::PointCloud<pcl::PointXYZL> cloud;
  cloud.reserve (rays);
  for (std::size_t i = 0; i < rays; ++i) {
    const std::size_t ray = organized ? i % steps * scan.beams + i / steps : i;
    if (std::isfinite (scan.points[ray].x()))
      cloud.push_back (pointAt (pose * scan.points[ray], scan.surface[ray]));
    else if (organized)
      cloud.push_back (missingPoint());
  }
  if (organized) {
    cloud.width = std::uint32_t (steps);
    cloud.height = std::uint32_t (scan.beams);
    cloud.is_dense = false;
  }
  setSensorPose (cloud, pose);
  return cloud;
}

SimulatedCloud
toCloud (const LidarScan& scan,
         const Lidar& lidar,
         const Scene& scene,
         CloudLayout layout)
{
  SimulatedCloud simulated{toSurfaceCloud (scan, lidar.pose, layout), {}};
  simulated.planes = labelBySize (simulated.cloud, surfacePlanes (scene));
  return simulated;
}

std::vector<LabeledPlane>
labelBySize (pcl::PointCloud<pcl::PointXYZL>& cloud, const std::vector<Plane>& surfaces)
{
  const std::vector<std::size_t> counts = countPoints (cloud, surfaces.size());
  std::vector<SurfaceId> by_size (surfaces.size());
  std::iota (by_size.begin(), by_size.end(), SurfaceId (1));
  std::stable_sort (by_size.begin(), by_size.end(), [&counts] (auto a, auto b) {
    return counts[a] > counts[b];
  });
  std::vector<LabeledPlane> planes;
  std::vector<std::uint32_t> label_of (surfaces.size() + 1, 0);
  for (const SurfaceId surface : by_size) {
    if (counts[surface] < fewest_points_of_plane)
      break;
    label_of[surface] = std::uint32_t (planes.size() + 1);
    planes.push_back ({label_of[surface], surfaces[surface - 1], counts[surface]});
  }
  for (auto& point : cloud)
    point.label = label_of[point.label];
  return planes;
}

} // namespace pcl_ops::simulation

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera.h"

#include <pcl/common/angles.h>
#include <pcl/common/point_tests.h>

#include <picture/view.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::apps {

namespace {

/** \brief How far away the middle one of the points is. */
float
medianDepth (const pcl::PointCloud<pcl::PointXYZ>& cloud, const View& view)
{
  std::vector<float> depths;
  for (const pcl::PointXYZ& point : cloud)
    if (pcl::isXYZFinite (point))
      depths.push_back (view.axes.row (2).dot (point.getVector3fMap() - view.eye));
  if (depths.empty())
    return 1.0f;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t> (depths.size() / 2);
  std::nth_element (depths.begin(), middle, depths.end());
  return *middle > 0.0f ? *middle : 1.0f;
}

} // namespace

Camera
cameraFor (const pcl::PointCloud<pcl::PointXYZ>& cloud,
           const std::vector<PlaneSegment>& planes,
           const Eigen::Vector3f& gravity_up,
           int width,
           int height)
{
  constexpr double kNarrowest = 1.0;
  constexpr double kWidest = 150.0;
  const View view = chooseView (cloud, planes, gravity_up, width, height);
  const Eigen::Vector2f middle =
      0.5f * Eigen::Vector2f (static_cast<float> (width), static_cast<float> (height));
  // The picture's optical axis need not go through its middle; a window's does.
  const Eigen::Vector2f aside = (middle - view.center) / view.focal;
  const Eigen::Vector3f ray =
      medianDepth (cloud, view) * (view.axes.transpose() * aside.homogeneous());
  Camera camera;
  camera.eye = view.eye.cast<double>();
  camera.target = (view.eye + ray).cast<double>();
  camera.up = -view.axes.row (1).transpose().cast<double>();
  // A single point would be seen at an angle of nothing.
  camera.angle = std::clamp (
      pcl::rad2deg (2.0 * std::atan2 (middle.y(), view.focal)), kNarrowest, kWidest);
  return camera;
}

int
pointSizeFor (std::size_t points, int width, int height)
{
  constexpr double kFilled = 1.6;
  constexpr double kSmallest = 2.0;
  constexpr double kLargest = 6.0;
  const double pixels = static_cast<double> (width) * height;
  const double side =
      std::sqrt (kFilled * pixels / std::max (1.0, static_cast<double> (points)));
  return static_cast<int> (std::lround (std::clamp (side, kSmallest, kLargest)));
}

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera.h"

#include <pcl/common/angles.h>
#include <pcl/common/point_tests.h>

#include <numbers/quantile.h>
#include <picture/view.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::apps {

namespace {

/** \brief How far away the middle one of the points is. */
float
medianDepth (const XyzCloud& cloud, const View& view)
{
  std::vector<float> depths;
  for (const pcl::PointXYZ& point : cloud)
    if (pcl::isXYZFinite (point))
      depths.push_back (view.axes.row (2).dot (point.getVector3fMap() - view.eye));
  const float median = quantile (depths, 0.5);
  return median > 0.0f ? median : 1.0f; // 1 for NaN
}

} // namespace

Camera
cameraFor (const XyzCloud& cloud,
           const std::vector<PlaneSegment>& planes,
           const Eigen::Vector3f& gravity_up,
           int width,
           int height)
{
  constexpr double narrowest = 1.0;
  constexpr double widest = 150.0;
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
      pcl::rad2deg (2.0 * std::atan2 (middle.y(), view.focal)), narrowest, widest);
  return camera;
}

int
pointSizeFor (std::size_t points, int width, int height)
{
  constexpr double filled = 1.6;
  constexpr double smallest = 2.0;
  constexpr double largest = 6.0;
  const double pixels = static_cast<double> (width) * height;
  const double side =
      std::sqrt (filled * pixels / std::max (1.0, static_cast<double> (points)));
  return static_cast<int> (std::lround (std::clamp (side, smallest, largest)));
}

} // namespace pcl_ops::apps

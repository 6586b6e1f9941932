// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include <pcl_ops/orientation.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

const char*
toString (Orientation orientation)
{
  switch (orientation) {
  case Orientation::Horizontal:
    return "horizontal";
  case Orientation::Vertical:
    return "vertical";
  case Orientation::Other:
    break;
  }
  return "other";
}

Orientation
orientationOf (const Eigen::Vector3d& normal,
               const Eigen::Vector3d& up,
               double tolerance)
{
  const double height = std::min (1.0, std::abs (normal.dot (up)));
  if (std::acos (height) <= tolerance)
    return Orientation::Horizontal;
  if (std::asin (height) <= tolerance)
    return Orientation::Vertical;
  return Orientation::Other;
}

double
slopeOf (const Eigen::Vector3d& normal, const Eigen::Vector3d& up)
{
  return std::atan2 (normal.cross (up).norm(), std::abs (normal.dot (up)));
}

} // namespace pcl_ops

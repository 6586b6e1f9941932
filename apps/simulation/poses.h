// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "draws.h"

namespace pcl_ops::simulation {

inline Eigen::Isometry3d
at (double x, double y, double z)
{
  return Eigen::Isometry3d (Eigen::Translation3d (x, y, z));
}

inline Eigen::Isometry3d
turned (double angle, const Eigen::Vector3d& axis)
{
  return Eigen::Isometry3d (Eigen::AngleAxisd (angle, axis));
}

/** \brief Uniform draw of an angle [rad] between two given in degrees. */
inline double
drawAngle (internal::RandomGenerator& generator,
           double lower_degrees,
           double upper_degrees)
{
  return drawBetween (generator, lower_degrees, upper_degrees) * pi / 180.0;
}

} // namespace pcl_ops::simulation

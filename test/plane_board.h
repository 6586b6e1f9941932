// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <pcl_ops/plane.h>

#include <cmath>

/** \brief A board as a detector would give it, of 20 x 20 points.
 * \param[in] size along and across
 * \param[in] noise points lie so far before and behind the board in turn [m] */
inline pcl_ops::PlaneSegment
board (const Eigen::Vector3d& middle,
       const Eigen::Vector3d& normal,
       const Eigen::Vector2d& size,
       double noise = 0.002)
{
  constexpr int points = 20;
  const Eigen::Vector3d up =
      std::abs (normal.z()) > 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d along = up.cross (normal).normalized();
  const Eigen::Vector3d across = normal.cross (along).normalized();
  pcl_ops::PlaneSegment plane;
  plane.centroid = middle;
  plane.normal = normal.normalized();
  plane.moments.origin = middle;
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j) {
      const double s = (i + 0.5) / points - 0.5, t = (j + 0.5) / points - 0.5;
      const double height = (i + j) % 2 == 0 ? noise : -noise;
      const Eigen::Vector3d place =
          size.x() * s * along + size.y() * t * across + height * plane.normal;
      plane.moments.add (place.x(), place.y(), place.z());
    }
  return plane;
}

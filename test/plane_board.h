// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

/** \brief The plane of a rectangular board of 20 x 20 points: centroid, normal and
 * moments, without inliers. A board that is not level stands upright.
 * \param[in] normal of the plane; if it is within 25 degrees of the z axis, the board
 * is level
 * \param[in] size width and height of an upright board; extents along x and y of a
 * level board [m]
 * \param[in] noise points lie by turns this far in front of the board and behind it [m]
 */
inline pcl_ops::PlaneSegment
board (const Eigen::Vector3d& middle,
       const Eigen::Vector3d& normal,
       const Eigen::Vector2d& size,
       double noise = 0.002)
{
  const bool is_level = std::abs (normal.z()) > 0.9; // the cosine of 25 degrees
  const Eigen::Vector3d towards_top =
      is_level ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d width = size.x() * towards_top.cross (normal).normalized();
  const Eigen::Vector3d height = size.y() * normal.cross (width).normalized();
  pcl_ops::PlaneSegment plane;
  plane.centroid = middle;
  plane.normal = normal.normalized();
  const Surface surface = {middle - 0.5 * (width + height), width, height};
  plane.moments = momentsOf (surface, 20, 20, noise);
  return plane;
}

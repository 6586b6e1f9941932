// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

/** \brief A rectangular board of 20 x 20 points as a detector returns it.
 * \param[in] size lengths of the edges along up x normal and across it [m]
 * \param[in] noise points lie this far in front of and behind the board in turn [m] */
inline pcl_ops::PlaneSegment
board (const Eigen::Vector3d& middle,
       const Eigen::Vector3d& normal,
       const Eigen::Vector2d& size,
       double noise = 0.002)
{
  const Eigen::Vector3d up =
      std::abs (normal.z()) > 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d along = size.x() * up.cross (normal).normalized();
  const Eigen::Vector3d across = size.y() * normal.cross (along).normalized();
  pcl_ops::PlaneSegment plane;
  plane.centroid = middle;
  plane.normal = normal.normalized();
  plane.moments =
      momentsOf ({middle - 0.5 * (along + across), along, across}, 20, 20, noise);
  return plane;
}

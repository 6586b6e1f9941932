// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace pcl_ops::internal {

/** \brief The axes u and v of a plane, as columns: a right-handed frame with its unit
 * normal as the third axis. They depend on the normal alone. */
inline Eigen::Matrix<double, 3, 2>
planeAxes (const Eigen::Vector3d& normal)
{
  Eigen::Matrix<double, 3, 2> axes;
  axes.col (0) = normal.unitOrthogonal();
  axes.col (1) = normal.cross (axes.col (0));
  return axes;
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <vector>

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

/** \brief Twice the area between two directions; above 0 where the second is to the
 * left of the first. */
inline double
cross (const Eigen::Vector2d& first, const Eigen::Vector2d& second)
{
  return first.x() * second.y() - first.y() * second.x();
}

/** \brief Twice the area of a triangle; above 0 where it runs counter-clockwise. */
inline double
twiceTheArea (const Eigen::Vector2d& a,
              const Eigen::Vector2d& b,
              const Eigen::Vector2d& c)
{
  return cross (b - a, c - a);
}

/** \brief Area of a polygon; above 0 where it runs counter-clockwise. */
inline double
areaOf (const std::vector<Eigen::Vector2d>& polygon)
{
  double twice = 0.0;
  // From the first corner: areas far from zero would have few digits left.
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice += twiceTheArea (polygon[0], polygon[i - 1], polygon[i]);
  return 0.5 * twice;
}

/** \brief Whether a point lies in a triangle that runs either way, or on its sides. */
inline bool
isWithin (const Eigen::Vector2d& point,
          const Eigen::Vector2d& a,
          const Eigen::Vector2d& b,
          const Eigen::Vector2d& c)
{
  const double first = twiceTheArea (a, b, point);
  const double second = twiceTheArea (b, c, point);
  const double third = twiceTheArea (c, a, point);
  return (first >= 0.0 && second >= 0.0 && third >= 0.0) ||
         (first <= 0.0 && second <= 0.0 && third <= 0.0);
}

} // namespace pcl_ops::internal

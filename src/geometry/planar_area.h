// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <vector>

namespace pcl_ops::internal {

/** \brief Returns two unit axes u and v in a plane as columns: u x v is its normal.
 * They depend on the normal only.
 * \param[in] normal unit normal */
inline Eigen::Matrix<double, 3, 2>
planeAxes (const Eigen::Vector3d& normal)
{
  Eigen::Matrix<double, 3, 2> axes;
  axes.col (0) = normal.unitOrthogonal();
  axes.col (1) = normal.cross (axes.col (0));
  return axes;
}

/** \brief Cross product: twice the signed area of the triangle that two vectors span;
 * positive if the second vector points to the left of the first one. */
inline double
cross (const Eigen::Vector2d& first, const Eigen::Vector2d& second)
{
  return first.x() * second.y() - first.y() * second.x();
}

/** \brief Twice the signed area of a triangle; positive if counter-clockwise. */
inline double
twiceTheArea (const Eigen::Vector2d& a,
              const Eigen::Vector2d& b,
              const Eigen::Vector2d& c)
{
  return cross (b - a, c - a);
}

/** \brief Signed area of a polygon; positive if counter-clockwise, 0 for fewer than
 * three corners. */
inline double
areaOf (const std::vector<Eigen::Vector2d>& polygon)
{
  double twice_the_area = 0.0;
  // Add triangles from the first corner: about a far origin the sum loses digits.
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice_the_area += twiceTheArea (polygon[0], polygon[i - 1], polygon[i]);
  return 0.5 * twice_the_area;
}

/** \brief Whether a point lies inside or on the sides of a triangle, which may be
 * clockwise or counter-clockwise. If its corners are on one line, all points of that
 * line do. */
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

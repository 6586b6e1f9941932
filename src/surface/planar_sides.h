// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace pcl_ops {

/** \brief Twice the area of a triangle; above 0 where it runs counter-clockwise. */
inline double
twiceTheArea (const Eigen::Vector2d& a,
              const Eigen::Vector2d& b,
              const Eigen::Vector2d& c)
{
  const Eigen::Vector2d first = b - a;
  const Eigen::Vector2d second = c - a;
  return first.x() * second.y() - first.y() * second.x();
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

} // namespace pcl_ops

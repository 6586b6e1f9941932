// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace pcl_ops::internal::buildings {

/** \brief The rotation that turns up to z the shortest way: x and y stay where up is z.
 *
 * With up = (a, b, c), as the axis of the turn is across up and z:
 *
 *     | 1 - a^2 / (1 + c)    -a b / (1 + c)    -a |
 *     |   -a b / (1 + c)   1 - b^2 / (1 + c)   -b |
 *     |         a                  b            c |
 *
 * Where up is nearly -z, which has no shortest way, it turns about x by half before.
 * Eigen's Quaternion::FromTwoVectors does the same, and compiles for 6 seconds. */
inline Eigen::Matrix3d
turnUpright (const Eigen::Vector3d& up)
{
  constexpr double least_cosine = -0.99; // below it 1 + c has lost two digits
  const Eigen::Vector3d axis = up.stableNormalized();
  const bool is_down = axis.z() < least_cosine;
  const double a = axis.x();
  const double b = is_down ? -axis.y() : axis.y();
  const double c = is_down ? -axis.z() : axis.z();
  Eigen::Matrix3d turn;
  turn << 1.0 - a * a / (1.0 + c), -a * b / (1.0 + c), -a, //
      -a * b / (1.0 + c), 1.0 - b * b / (1.0 + c), -b,     //
      a, b, c;
  if (is_down)
    turn.rightCols<2>() *= -1.0;
  return turn;
}

} // namespace pcl_ops::internal::buildings

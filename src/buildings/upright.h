// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace pcl_ops::internal::buildings {

/** \brief The smallest rotation that takes up, any length but 0, to z: x and y stay
 * where up is z.
 *
 * With up = (a, b, c), as the axis of the rotation is perpendicular to up and z:
 *
 *     | 1 - a^2 / (1 + c)    -a b / (1 + c)    -a |
 *     |   -a b / (1 + c)   1 - b^2 / (1 + c)   -b |
 *     |         a                  b            c |
 *
 * Where up is nearly -z, which has no shortest way, half a turn about x comes before.
 * Eigen's Quaternion::FromTwoVectors does the same, and compiles for 6 seconds. */
inline Eigen::Matrix3d
turnUpright (const Eigen::Vector3d& up)
{
  constexpr double least_cosine = -0.99; // below it 1 + c has lost two digits
  const Eigen::Vector3d half_turn (1.0, -1.0, -1.0);
  const Eigen::Vector3d axis = up.stableNormalized();
  if (axis.z() < least_cosine)
    return turnUpright (half_turn.cwiseProduct (axis)) * half_turn.asDiagonal();
  const double a = axis.x();
  const double b = axis.y();
  const double c = axis.z();
  Eigen::Matrix3d turn;
  turn << 1.0 - a * a / (1.0 + c), -a * b / (1.0 + c), -a, //
      -a * b / (1.0 + c), 1.0 - b * b / (1.0 + c), -b,     //
      a, b, c;
  return turn;
}

} // namespace pcl_ops::internal::buildings

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace pcl_ops::internal::buildings {

/** \brief Returns a rotation that turns the direction \p up to that of +z: the smallest
 * one, unless \p up is nearly -z; the identity if \p up is along +z.
 *
 * With the unit vector up = (a, b, c), as the axis of the rotation is perpendicular to
 * up and z:
 *
 *     | 1 - a^2 / (1 + c)    -a b / (1 + c)    -a |
 *     |   -a b / (1 + c)   1 - b^2 / (1 + c)   -b |
 *     |         a                  b            c |
 *
 * For up = -z the smallest rotation is not unique. If up is nearly -z, half a turn
 * about x comes first. Eigen's Quaternion::FromTwoVectors does the same, but takes 6
 * seconds to compile.
 * \param[in] up of any length but 0 */
inline Eigen::Matrix3d
turnUpright (const Eigen::Vector3d& up)
{
  constexpr double smallest_cosine = -0.99; // at less, 1 + c loses over two digits
  const Eigen::Vector3d half_turn (1.0, -1.0, -1.0);
  const Eigen::Vector3d axis = up.stableNormalized();
  if (axis.z() < smallest_cosine)
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

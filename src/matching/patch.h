// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <pcl_ops/plane.h>

#include <array>
#include <optional>

namespace pcl_ops::internal {

/** \brief A plane that ends, as its moments tell: the rectangle that has them, too. */
struct Patch {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** \brief Unit vectors: along, across, and the normal. */
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  /** \brief Half the sides of the rectangle, along and across [m]. */
  Eigen::Vector2d half = Eigen::Vector2d::Zero();
  /** \brief Of heights of points over the plane [m^2]. */
  double noise = 0.0;

  Eigen::Vector3d
  normal () const
  {
    return axes.col (2);
  }
  double
  area () const
  {
    return 4.0 * half.prod();
  }
};

/** \return nothing for fewer than three points, or if they are on one line or all equal
 */
std::optional<Patch>
patchOf (const PlaneSegment& plane);

/** \brief The same in another frame. */
Patch
moved (const Eigen::Isometry3d& motion, Patch patch);

/** \brief In order around the patch. */
std::array<Eigen::Vector3d, 4>
cornersOf (const Patch& patch);

/** \brief The area two patches have in common once the second is projected onto the
 * first [m^2]. */
double
commonArea (const Patch& first, const Patch& second);

} // namespace pcl_ops::internal

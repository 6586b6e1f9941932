// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief A plane that is not vertical, in meters, z up. */
struct PlaneFromAbove {
  /** \brief Up. */
  Eigen::Vector3d normal;
  Eigen::Vector3d center;
  std::vector<Eigen::Vector3d> hull;
  double area;
};

/** \brief Whether a plane is a part of the ground: others go on where it ends, at its
 * height and nearly its slope, along much of its outline, or rise from it there, as the
 * slope above a terrace does. A roof ends at steps: along its outline something is far
 * below it. */
bool
isContinued (const PlaneFromAbove& plane, const std::vector<PlaneFromAbove>& all);

/** \brief Whether no other plane lies below most of a plane, as below the ground.
 * \param[in] min_drop what is less far below does not count, as the next field of a
 * slope [m] */
bool
isLowest (const PlaneFromAbove& plane,
          const std::vector<PlaneFromAbove>& all,
          double min_drop);

} // namespace pcl_ops::internal::buildings

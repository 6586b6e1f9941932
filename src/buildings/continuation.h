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

/** \brief Whether a plane is a part of the ground. Along the outline of a roof
 * something is far below it; beside a part of the ground others go on at its height and
 * nearly its slope, or are far above it, as the slope over a terrace. It is one if at
 * least half as many places along the outline are of the second kind as of the first.
 * \param[in] plane one of \p all */
bool
isPartOfGround (const PlaneFromAbove& plane, const std::vector<PlaneFromAbove>& all);

/** \brief Whether no other plane lies below most of a plane, as below the ground.
 * \param[in] min_drop planes less far below do not count, as the next field of a
 * slope [m] */
bool
isLowest (const PlaneFromAbove& plane,
          const std::vector<PlaneFromAbove>& all,
          double min_drop);

} // namespace pcl_ops::internal::buildings

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane.h>

#include <optional>

namespace pcl_ops::internal {

/** \brief The points origin + t direction. */
struct Line {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /** \brief Of length 1. */
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();

  Eigen::Vector3d
  at (double t) const
  {
    return origin + t * direction;
  }
  double
  placeOf (const Eigen::Vector3d& point) const
  {
    return direction.dot (point - origin);
  }
};

/** \brief The line that two planes have in common, with its origin next to the middle
 * of their centroids.
 * \param[in] min_sine nothing for planes at an angle with a smaller sine */
std::optional<Line>
meetingLine (const PlaneSegment& first, const PlaneSegment& second, double min_sine);

/** \brief The point that three planes have in common.
 * \param[in] min_sine nothing where one of them is at an angle with a smaller sine to
 * the line of the others */
std::optional<Eigen::Vector3d>
meetingPoint (const PlaneSegment& first,
              const PlaneSegment& second,
              const PlaneSegment& third,
              double min_sine);

} // namespace pcl_ops::internal

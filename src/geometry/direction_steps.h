// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "cloud/points.h"

namespace pcl_ops::internal {

/** \brief Measures how regular the directions from a position to the points are.
 *
 * A step is the angle between the direction to a point and the nearest other direction.
 * The result is the share of steps that agree to 12 % with one of the two commonest
 * steps. A sensor measures in steps of one angle, some lidars of two angles. Seen from
 * the sensor the share is 0.7 to 1 for scans and depth images (0.3 if scan lines
 * cross); seen from 3 m beside the sensor it is below 0.5. For points thinned evenly in
 * space it is below 0.2 from any position.
 * \return the share, 0 to 1. It is 0 if fewer than 100, or fewer than half, of the
 * sampled directions have another direction near enough to measure a step */
double
shareOfCommonSteps (const Coordinates& points, const Eigen::Vector3d& position);

/** \brief Whether the points were measured from a position, as far as the steps between
 * directions tell. */
enum class StepsSay { Yes, No, CannotTell };

/** \brief Tells whether the points were measured from a position, by \ref
 * shareOfCommonSteps. At the position of the sensor this share is high, or higher than
 * at positions nearby. At other positions it is lower than at one of the positions
 * nearby.
 */
StepsSay
seenByItsSteps (const Coordinates& points, const Eigen::Vector3d& position);

} // namespace pcl_ops::internal

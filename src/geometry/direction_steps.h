// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "cloud/points.h"

namespace pcl_ops::internal {

/** \brief The share of points whose nearest neighbor in direction, as seen from a
 * place, is at one of the two commonest angles, each to 12 %.
 *
 * A sensor measures in even steps of angles: of scans and depth images seen from the
 * sensor it is 0.7 to 1 (two steps, as some lidars have beams of two kinds; 0.3 for
 * those whose lines cross), from 3 m beside it below 0.5. It is below 0.2 where points
 * are thinned evenly in space, from anywhere.
 * \return 0 where fewer than half of the points, or than 100, have a neighbor near
 * enough to tell */
double
shareOfCommonSteps (const Coordinates& points, const Eigen::Vector3d& place);

enum class StepsSay { Yes, No, CannotTell };

/** \brief Whether points were measured from a place, by \ref shareOfCommonSteps: it is
 * high there, or higher than at places nearby; elsewhere it rises to one side. */
StepsSay
seenByItsSteps (const Coordinates& points, const Eigen::Vector3d& place);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

namespace pcl_ops::internal {

/** \brief Returns for each axis the step that coordinates were rounded to [m], as 0.01
 * in a file with two decimals; 0 for an axis whose coordinates were not rounded. It is
 * the smallest difference between coordinates of a sample, so that a shift does not
 * matter.
 */
Eigen::Vector3d
coordinateSteps (const Coordinates& points);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/point_tree.h"
#include "cloud/points.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief The levels of a quantized depth: planes at right angles to one direction that
 * all points lie on, or near to if coordinates were rounded later. */
struct DepthLevels {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  /** \brief For each point how far the level is from the next ones [m]; empty where
   * there are no levels. A point may be anywhere within its step, which is what makes
   * the depth of levels the depth of points: its variance is step^2 / 12. */
  std::vector<float> step;
};

/** \brief Looks for levels in any direction, as a cloud may have been turned. */
DepthLevels
findDepthLevels (const Coordinates& points, const PointTree& tree);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/point_tree.h"
#include "cloud/points.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief The levels of a quantized depth, as depth cameras have: parallel planes that
 * all points lie on, or near to if coordinates were rounded later. */
struct DepthLevels {
  /** \brief The common normal of the levels, of length 1; zero where there are none. */
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  /** \brief For each point how far its level is from the next ones [m]; empty where
   * there are no levels. What was measured may be anywhere within that step: its
   * variance along the direction is step^2 / 12. */
  std::vector<float> step;
};

/** \brief Looks for levels in any direction, as a cloud may have been turned.
 * \param[in] tree of the same points */
DepthLevels
findDepthLevels (const Coordinates& points, const PointTree& tree);

} // namespace pcl_ops::internal

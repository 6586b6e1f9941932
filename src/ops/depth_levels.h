// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/point_tree.h"
#include "cloud/points.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief The levels of quantized depth, as from depth cameras: parallel planes on
 * which all points lie, exactly, or nearly if coordinates were rounded later. */
struct DepthLevels {
  /** \brief The common unit normal of the levels; zero if the cloud has no levels. */
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  /** \brief For each point the median distance [m] between adjacent levels near the
   * level of the point; empty if the cloud has no levels. The true depth may be
   * anywhere within this step: quantization has a variance of step^2 / 12 along the
   * direction. */
  std::vector<float> step;
};

/** \brief Searches for levels in any direction, as the cloud may have been rotated.
 * \param[in] tree k-d tree of \p points
 * \return a zero direction and an empty step if the cloud has no levels, always for
 * fewer than 2000 points */
DepthLevels
findDepthLevels (const Coordinates& points, const PointTree& tree);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "plane_sample.h"

#include <cstddef>
#include <vector>

namespace pcl_ops::apps {

/** \brief Survey points in a box around a sampled point, also those that are not in the
 * sample. */
struct DenseBox {
  /** \brief Group of the sampled point: the position of its plane in the list of
   * planes, or the number of planes if it is on no plane. */
  std::size_t group = 0;
  /** \brief In the frame of the survey [m]. */
  Eigen::AlignedBox3d box;
  /** \brief All points in the box relative to its center; around a point on no plane,
   * all points on no plane. Of more than 20,000 the first ones in the order of the
   * survey. */
  std::vector<Eigen::Vector3f> points;
};

/** \brief Collects some thousand points around each of a few points of the largest
 * planes, and of a few points on no plane.
 * \param[in] list of planes by falling number of points, as for \ref samplePlanes
 * \param[in] sample of the points of these planes, and of the points on no plane
 * \throws WorkError as \p for_each_point does */
std::vector<DenseBox>
denseBoxes (const nlohmann::ordered_json& list,
            const PlaneSample& sample,
            const ForEachLabeledPoint& for_each_point);

} // namespace pcl_ops::apps

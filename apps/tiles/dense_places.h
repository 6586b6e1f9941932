// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "plane_sample.h"

#include <cstddef>
#include <vector>

namespace pcl_ops::apps {

/** \brief What is around a place of a survey, as dense as the survey is. */
struct DensePlace {
  /** \brief The group of its middle: the position of its plane, or the number of planes
   * for none. */
  std::size_t group = 0;
  Eigen::AlignedBox3d box;
  /** \brief Relative to the middle of the box; around a point on none only such. */
  std::vector<Eigen::Vector3f> points;
};

/** \brief Some thousand points each, around points of the largest planes and around
 * some that are on none.
 * \throws WorkError as \p points does */
std::vector<DensePlace>
densePlaces (const nlohmann::ordered_json& list,
             const PlaneSample& sample,
             const LabelledPoints& points);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/up_axis.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_ops::apps {

/** \brief The up axis of a sequence of clouds. */
struct CommonUp {
  /** \brief Its confidence is the sum of the confidences of the agreeing axes, divided
   * by that of all axes. */
  UpAxis axis;
  /** \brief Number of axes of single clouds that agree. */
  std::size_t agreeing;
};

/** \brief Returns the mean, weighted by confidence, of the up axes that agree. For each
 * axis there is a group: all axes within 15 degrees of it. The axes of the group with
 * the largest sum of confidences are those that agree.
 * \param[in] axes of single clouds, in one common frame
 * \return nothing if the agreeing axes are half of all axes or fewer, or have half of
 * the sum of all confidences or less */
std::optional<CommonUp>
commonUp (const std::vector<UpAxis>& axes);

} // namespace pcl_ops::apps

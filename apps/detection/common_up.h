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
  /** \brief Its confidence is the sum over the agreeing axes divided by that over all.
   */
  UpAxis axis;
  /** \brief Number of axes of single clouds that agree. */
  std::size_t agreeing;
};

/** \brief Returns the mean, weighted by confidence, of a group of up axes: those within
 * 15 degrees of one of them. Of all such groups it takes the one with the largest sum
 * of confidences. The axes of this group are those that agree.
 * \param[in] axes of single clouds, in one common frame
 * \return nothing if the agreeing axes are half of all or fewer, or have half of the
 * total confidence or less */
std::optional<CommonUp>
commonUp (const std::vector<UpAxis>& axes);

} // namespace pcl_ops::apps

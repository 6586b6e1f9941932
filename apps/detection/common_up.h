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
  /** \brief The confidence is that of the agreeing answers divided by that of all. */
  UpAxis axis;
  /** \brief Number of answers that agree with the axis. */
  std::size_t answers;
};

/** \brief Returns the mean up axis of the single clouds that agree with each other,
 * weighted by confidence.
 * \param[in] answers up axes of single clouds, in one common frame
 * \return nothing if the agreeing answers have half of the total confidence or less */
std::optional<CommonUp>
commonUp (const std::vector<UpAxis>& answers);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/up_axis.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_ops::apps {

/** \brief Which way is up in a sequence of clouds. */
struct CommonUp {
  /** \brief Its confidence is the share of all answers' confidence that agrees with it.
   */
  UpAxis axis;
  /** \brief How many of the answers agree with it. */
  std::size_t answers;
};

/** \brief The mean of the answers of single clouds that agree with each other, weighted
 * by their confidence.
 * \param[in] answers in one frame
 * \return nothing if those that agree have no more than half of the confidence of all */
std::optional<CommonUp>
commonUp (const std::vector<UpAxis>& answers);

} // namespace pcl_ops::apps

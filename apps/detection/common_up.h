// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/up_axis.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_ops::apps {

/** \brief Which way is up in a sequence. */
struct CommonUp {
  UpAxis axis;
  /** \brief How many of the answers agree with it. */
  std::size_t answers;
};

/** \brief What most answers of single clouds agree on, each with the weight of its
 * confidence; the confidence is the share of the weight that agrees.
 * \param[in] answers in one frame
 * \return nothing where no half of the weight agrees */
std::optional<CommonUp>
commonUp (const std::vector<UpAxis>& answers);

} // namespace pcl_ops::apps

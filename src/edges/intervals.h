// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace pcl_ops::internal {

/** \brief From where to where on a line. */
struct Stretch {
  double from = 0.0;
  double to = 0.0;

  double
  length () const
  {
    return to - from;
  }
};

using Stretches = std::vector<Stretch>;

/** \brief Stretches of a line from place to place, ascending.
 * \param[in] places in any order
 * \param[in] bridged_gap a larger gap begins another stretch */
Stretches
stretchesOf (const std::vector<double>& places, double bridged_gap);

/** \brief What two lists of stretches have in common, both ascending.
 * \param[in] min_length shorter ones are left out */
Stretches
inCommon (const Stretches& first, const Stretches& second, double min_length);

} // namespace pcl_ops::internal

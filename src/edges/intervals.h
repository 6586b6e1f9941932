// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace pcl_ops::internal {

/** \brief From where to where on a line. */
struct Interval {
  double from = 0.0;
  double to = 0.0;

  double
  length () const
  {
    return to - from;
  }
};

using Intervals = std::vector<Interval>;

/** \brief Intervals of a line from place to place, ascending.
 * \param[in] places in any order
 * \param[in] max_gap a larger gap begins another interval */
Intervals
intervalsOf (const std::vector<double>& places, double max_gap);

/** \brief What two lists of intervals have in common, both ascending.
 * \param[in] min_length shorter ones are left out */
Intervals
inCommon (const Intervals& first, const Intervals& second, double min_length);

} // namespace pcl_ops::internal

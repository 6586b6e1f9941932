// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace pcl_ops::internal {

/** \brief A part of a line, by places along it [m]. */
struct Interval {
  double from, to;

  double
  length () const
  {
    return to - from;
  }
};

/** \brief Ascending, none touching another. */
using Intervals = std::vector<Interval>;

/** \brief Intervals from place to place, ascending; a gap that is larger than \p
 * max_gap begins another. */
inline Intervals
intervalsOf (std::vector<double> places, double max_gap)
{
  std::sort (places.begin(), places.end());
  Intervals intervals;
  for (const double place : places) {
    if (intervals.empty() || place - intervals.back().to > max_gap)
      intervals.push_back ({place, place});
    intervals.back().to = place;
  }
  return intervals;
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace pcl_ops::internal {

/** \brief An interval on a line, from its smallest to its largest coordinate along the
 * line [m]. */
struct Interval {
  double from, to;

  double
  length () const
  {
    return to - from;
  }
};

/** \brief Disjoint intervals on one line, in ascending order. */
using Intervals = std::vector<Interval>;

/** \brief Joins points on a line into intervals.
 * \param[in] coordinates of the points along the line [m], in any order
 * \param[in] max_gap largest distance between successive points of one interval [m]
 * \return intervals that begin and end at points; of length 0 around a single point */
inline Intervals
intervalsOf (std::vector<double> coordinates, double max_gap)
{
  std::sort (coordinates.begin(), coordinates.end());
  Intervals intervals;
  for (const double coordinate : coordinates) {
    if (intervals.empty() || coordinate - intervals.back().to > max_gap)
      intervals.push_back ({coordinate, coordinate});
    intervals.back().to = coordinate;
  }
  return intervals;
}

} // namespace pcl_ops::internal

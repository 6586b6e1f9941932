// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace pcl_ops::internal {

/** \brief A piece of a line: where it begins and ends, by coordinates along the line
 * [m].
 */
struct Interval {
  double from, to;

  double
  length () const
  {
    return to - from;
  }
};

/** \brief Intervals of one line, ascending, with gaps between them. */
using Intervals = std::vector<Interval>;

/** \brief The intervals that points on a line cover, if gaps up to \p max_gap between
 * neighbors count as covered.
 * \param[in] coordinates of the points along the line [m], in any order */
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

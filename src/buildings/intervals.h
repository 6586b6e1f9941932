// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief A part of a line between two positions along it [m]. */
struct Interval {
  double from, to;

  double
  length () const
  {
    return to - from;
  }
};

/** \brief Intervals of one line, ascending; no two touch each other. */
using Intervals = std::vector<Interval>;

/** \brief Returns the union of both lists, with gaps up to \p max_gap [m] closed. */
inline Intervals
unionOf (Intervals intervals, const Intervals& others, double max_gap)
{
  intervals.insert (intervals.end(), others.begin(), others.end());
  std::sort (intervals.begin(),
             intervals.end(),
             [] (const Interval& a, const Interval& b) { return a.from < b.from; });
  Intervals all;
  for (const Interval& interval : intervals)
    if (all.empty() || interval.from - all.back().to > max_gap)
      all.push_back (interval);
    else
      all.back().to = std::max (all.back().to, interval.to);
  return all;
}

/** \brief Returns the intervals that positions on a line [m] cover. A gap between
 * neighboring positions larger than \p max_gap [m] separates two intervals. */
inline Intervals
intervalsOf (const std::vector<double>& positions, double max_gap)
{
  Intervals points;
  points.reserve (positions.size());
  for (const double position : positions)
    points.push_back ({position, position});
  return unionOf (std::move (points), {}, max_gap);
}

/** \brief Returns the parts of \p intervals that \p others do not cover. */
inline Intervals
without (const Intervals& intervals, const Intervals& others)
{
  Intervals uncovered;
  for (Interval rest : intervals) { // the part that no interval so far has covered
    for (const Interval& other : others) {
      if (other.to <= rest.from || other.from >= rest.to)
        continue;
      if (other.from > rest.from)
        uncovered.push_back ({rest.from, other.from});
      rest.from = std::min (rest.to, other.to);
    }
    if (rest.from < rest.to)
      uncovered.push_back (rest);
  }
  return uncovered;
}

/** \brief Returns the length of the parts of an interval that \p others cover [m]. */
inline double
coveredLength (const Interval& interval, const Intervals& others)
{
  double length = 0.0;
  for (const Interval& other : others)
    length += std::max (
        0.0, std::min (interval.to, other.to) - std::max (interval.from, other.from));
  return length;
}

} // namespace pcl_ops::internal::buildings

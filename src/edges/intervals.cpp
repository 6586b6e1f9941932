// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges/intervals.h"

#include <algorithm>

namespace pcl_ops::internal {

namespace {

/** \brief Puts what lies in the same of many bins, each as wide as the gap, into one
 * interval; ascending. Then hardly anything is left to sort. */
Intervals
binned (const std::vector<double>& places, double low, double max_gap, double bins)
{
  Intervals of_bin (static_cast<std::size_t> (bins), {1.0, 0.0});
  for (const double place : places) {
    const auto bin = static_cast<std::size_t> ((place - low) / max_gap);
    Interval& interval = of_bin[std::min (bin, of_bin.size() - 1)];
    const bool is_first = interval.from > interval.to;
    interval.from = is_first ? place : std::min (interval.from, place);
    interval.to = is_first ? place : std::max (interval.to, place);
  }
  const auto is_empty = [] (const Interval& interval) {
    return interval.from > interval.to;
  };
  of_bin.erase (std::remove_if (of_bin.begin(), of_bin.end(), is_empty), of_bin.end());
  return of_bin;
}

Intervals
sorted (std::vector<double> places)
{
  std::sort (places.begin(), places.end());
  Intervals intervals;
  for (const double place : places)
    intervals.push_back ({place, place});
  return intervals;
}

} // namespace

Intervals
intervalsOf (const std::vector<double>& places, double max_gap)
{
  if (places.empty())
    return {};
  const auto [low, high] = std::minmax_element (places.begin(), places.end());
  const double bins = (*high - *low) / max_gap + 1.0;
  const bool has_bins = bins <= static_cast<double> (places.size()); // not where NaN
  Intervals intervals;
  for (const Interval& piece :
       has_bins ? binned (places, *low, max_gap, bins) : sorted (places)) {
    if (intervals.empty() || piece.from - intervals.back().to > max_gap)
      intervals.push_back (piece);
    intervals.back().to = piece.to;
  }
  return intervals;
}

Intervals
inCommon (const Intervals& first, const Intervals& second, double min_length)
{
  Intervals common;
  for (auto a = first.begin(), b = second.begin();
       a != first.end() && b != second.end();) {
    const Interval both{std::max (a->from, b->from), std::min (a->to, b->to)};
    if (both.length() >= min_length && both.length() > 0.0)
      common.push_back (both);
    (a->to < b->to ? a : b)++;
  }
  return common;
}

} // namespace pcl_ops::internal

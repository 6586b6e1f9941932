// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges/stretches.h"

#include <algorithm>

namespace pcl_ops::internal {

namespace {

/** \brief Puts what lies in the same of many bins, each as wide as the gap, into one
 * stretch; ascending. Then hardly anything is left to sort. */
Stretches
binned (const std::vector<double>& places, double low, double bridged_gap, double bins)
{
  Stretches of_bin (static_cast<std::size_t> (bins), {1.0, 0.0});
  for (const double place : places) {
    const auto bin = static_cast<std::size_t> ((place - low) / bridged_gap);
    Stretch& stretch = of_bin[std::min (bin, of_bin.size() - 1)];
    const bool is_first = stretch.from > stretch.to;
    stretch.from = is_first ? place : std::min (stretch.from, place);
    stretch.to = is_first ? place : std::max (stretch.to, place);
  }
  const auto is_empty = [] (const Stretch& stretch) {
    return stretch.from > stretch.to;
  };
  of_bin.erase (std::remove_if (of_bin.begin(), of_bin.end(), is_empty), of_bin.end());
  return of_bin;
}

Stretches
sorted (std::vector<double> places)
{
  std::sort (places.begin(), places.end());
  Stretches stretches;
  for (const double place : places)
    stretches.push_back ({place, place});
  return stretches;
}

} // namespace

Stretches
stretchesOf (const std::vector<double>& places, double bridged_gap)
{
  if (places.empty())
    return {};
  const auto [low, high] = std::minmax_element (places.begin(), places.end());
  const double bins = (*high - *low) / bridged_gap + 1.0;
  const bool has_bins = bins <= static_cast<double> (places.size()); // not where NaN
  Stretches stretches;
  for (const Stretch& piece :
       has_bins ? binned (places, *low, bridged_gap, bins) : sorted (places)) {
    if (stretches.empty() || piece.from - stretches.back().to > bridged_gap)
      stretches.push_back (piece);
    stretches.back().to = piece.to;
  }
  return stretches;
}

Stretches
inCommon (const Stretches& first, const Stretches& second, double min_length)
{
  Stretches common;
  for (auto a = first.begin(), b = second.begin();
       a != first.end() && b != second.end();) {
    const Stretch both{std::max (a->from, b->from), std::min (a->to, b->to)};
    if (both.length() >= min_length && both.length() > 0.0)
      common.push_back (both);
    (a->to < b->to ? a : b)++;
  }
  return common;
}

} // namespace pcl_ops::internal

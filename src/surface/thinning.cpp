// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "thinning.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace pcl_ops {

namespace {

using Cell = std::pair<std::int64_t, std::int64_t>;
using Cells = std::map<Cell, std::vector<std::size_t>>;

bool
isSurrounded (const Cells& cells, const Cell& cell)
{
  for (const std::int64_t x : {-1, 0, 1})
    for (const std::int64_t y : {-1, 0, 1})
      if (cells.count ({cell.first + x, cell.second + y}) == 0)
        return false;
  return true;
}

} // namespace

WeightedPoints
thinInside (const PlanarPoints& points, double cell)
{
  Cells cells;
  for (std::size_t i = 0; i < points.size(); ++i)
    cells[{std::llround (points[i].x() / cell), std::llround (points[i].y() / cell)}]
        .push_back (i);
  WeightedPoints thinned;
  for (const auto& [place, members] : cells) {
    const bool is_inside = isSurrounded (cells, place);
    for (std::size_t m = 0; m < (is_inside ? 1 : members.size()); ++m) {
      thinned.points.push_back (points[members[m]]);
      thinned.weights.push_back (is_inside ? members.size() : 1);
    }
  }
  return thinned;
}

} // namespace pcl_ops

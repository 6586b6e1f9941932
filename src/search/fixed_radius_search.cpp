// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_sorting.h"
#include <pcl_ops/fixed_radius_search.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace pcl_ops {

namespace {

// The radius, or more where cells would hold next to no points: they cost, too.
double
cellEdge (const Coordinates& points, double radius)
{
  constexpr double points_per_cell = 16.0;
  const double most_cells = static_cast<double> (points.size()) / points_per_cell;
  return std::max (radius, cellSizeFor (points, std::max (1.0, most_cells)));
}

} // namespace

FixedRadiusSearch::FixedRadiusSearch (const Coordinates& points,
                                      double radius,
                                      unsigned threads)
: squared_radius_ (static_cast<float> (radius * radius))
{
  GriddedPoints gridded = gridPoints (points, cellEdge (points, radius), threads);
  neighbours_of_cell_ = std::move (gridded.grid.neighbours);
  const std::vector<std::uint32_t> count =
      countPerCell (gridded.cell_of_point, neighbours_of_cell_.size());
  cell_begin_.assign (1, 0);
  std::partial_sum (count.begin(), count.end(), std::back_inserter (cell_begin_));
  points_.resize (points.size());
  forPlacesByCell (
      gridded.cell_of_point, cell_begin_, [&] (std::size_t i, std::uint32_t place) {
        points_.x[place] = points.x[i];
        points_.y[place] = points.y[i];
        points_.z[place] = points.z[i];
      });
}

void
FixedRadiusSearch::find (std::uint32_t point, Positions& neighbours) const
{
  const float x = points_.x[point], y = points_.y[point], z = points_.z[point];
  const auto next_cell =
      std::upper_bound (cell_begin_.begin(), cell_begin_.end(), point);
  const auto own_cell = static_cast<std::size_t> (next_cell - cell_begin_.begin()) - 1;
  std::size_t number = 0;
  for (const std::uint32_t neighbour : neighbours_of_cell_[own_cell]) {
    const std::uint32_t* const cell = &cell_begin_[neighbour];
    neighbours.resize (number + (cell[1] - cell[0]));
    for (std::uint32_t i = cell[0]; i < cell[1]; ++i) {
      const float dx = points_.x[i] - x, dy = points_.y[i] - y, dz = points_.z[i] - z;
      // Written always, counted if near: no branch to mispredict.
      neighbours[number] = i;
      number += dx * dx + dy * dy + dz * dz <= squared_radius_;
    }
  }
  neighbours.resize (number);
}

} // namespace pcl_ops

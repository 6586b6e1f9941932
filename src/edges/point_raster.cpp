// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges/point_raster.h"

#include "search/counting_sort.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl_ops::internal {

namespace {

/** \brief The edge of cells with some points each; of long and thin planes longer, so
 * that there are never more cells than points. */
double
cellEdge (const Eigen::Vector2d& size, std::size_t points)
{
  constexpr double points_per_cell = 8.0;
  const double share = points_per_cell / static_cast<double> (points);
  const double edge =
      std::max (std::sqrt (share * size.prod()), share * size.maxCoeff());
  return edge > 0.0 ? edge : 1.0;
}

} // namespace

PointRaster::PointRaster (PlanarPoints points)
{
  begins_.assign (2, 0);
  const auto is_broken = [] (const Eigen::Vector2d& point) {
    return !point.allFinite();
  };
  points.erase (std::remove_if (points.begin(), points.end(), is_broken), points.end());
  if (points.empty())
    return;
  Eigen::Vector2d high = low_ = points.front();
  for (const Eigen::Vector2d& point : points) {
    low_ = low_.cwiseMin (point);
    high = high.cwiseMax (point);
  }
  size_ = high - low_;
  cell_ = cellEdge (size_, points.size());
  cells_per_meter_ = 1.0 / cell_;
  columns_ = static_cast<std::size_t> (size_.x() / cell_) + 1;
  rows_ = static_cast<std::size_t> (size_.y() / cell_) + 1;
  std::vector<std::uint32_t> cells (points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    cells[i] = static_cast<std::uint32_t> (cellOf (points[i].y() - low_.y(), rows_) *
                                               columns_ +
                                           cellOf (points[i].x() - low_.x(), columns_));
  begins_.assign (columns_ * rows_ + 1, 0);
  findBegins (cells, begins_);
  points_.resize (points.size());
  forPlaces (cells, begins_, [&] (std::size_t item, std::size_t place) {
    points_[place] = points[item];
  });
}

std::size_t
PointRaster::cellOf (double offset, std::size_t cells) const
{
  const double last = static_cast<double> (cells) - 1.0;
  return static_cast<std::size_t> (std::clamp (offset * cells_per_meter_, 0.0, last));
}

PointRaster::Run
PointRaster::cellsBeside (const PlanarLine& line, double reach, std::size_t row) const
{
  constexpr double rounding = 1e-9;
  // Distances to the left side of the row at its lower and its upper edge.
  const Eigen::Vector2d lower =
      low_ + Eigen::Vector2d (0.0, cell_ * static_cast<double> (row));
  const double at_lower = line.distance (lower);
  const double at_upper = line.distance (lower + Eigen::Vector2d (0.0, cell_));
  const double slack = reach + rounding * cell_;
  const double least = std::min (at_lower, at_upper) - slack;
  const double most = std::max (at_lower, at_upper) + slack;
  // They fall by the direction's y for each meter to the right.
  const double fall = line.direction.y();
  const double width = static_cast<double> (columns_) * cell_;
  if (std::abs (fall) * width < rounding * cell_)
    return least <= 0.0 && most >= 0.0 ? Run{0, columns_} : Run{0, 0};
  const double left = std::min (least / fall, most / fall);
  const double right = std::max (least / fall, most / fall);
  if (right < 0.0 || left > width)
    return {0, 0};
  return {cellOf (left, columns_), cellOf (right, columns_) + 1};
}

std::vector<double>
PointRaster::placesBeside (const PlanarLine& line, double reach) const
{
  if (points_.empty() || std::abs (line.distance (center())) > radius() + reach)
    return {};
  std::vector<Run> runs; // of points
  std::size_t most = 0;
  for (std::size_t row = 0; row < rows_; ++row) {
    const Run cells = cellsBeside (line, reach, row);
    const std::size_t* const begins = &begins_[row * columns_];
    runs.push_back ({begins[cells.begin], begins[cells.end]});
    most += runs.back().end - runs.back().begin;
  }
  std::vector<double> places (most);
  std::size_t number = 0;
  for (const Run& run : runs)
    for (std::size_t i = run.begin; i < run.end; ++i) {
      // Written in any case, counted if beside: a jump would be guessed wrongly.
      places[number] = line.direction.dot (points_[i] - line.origin);
      number += std::abs (line.distance (points_[i])) <= reach ? 1 : 0;
    }
  places.resize (number);
  return places;
}

} // namespace pcl_ops::internal

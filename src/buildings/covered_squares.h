// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "constants.h"
#include "plan_cells.h"
#include "planar_area.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Returns the mean density of points [1/m^2] over squares of one meter in the
 * box that have points; infinite without points. */
inline double
meanDensityOf (const PlanPoints& points, const Eigen::AlignedBox2d& box)
{
  double points_inside = 0.0;
  std::set<std::pair<long, long>> square_meters;
  for (const Eigen::Vector3d& point : points)
    if (box.contains (point.head<2>().eval())) {
      points_inside += 1.0;
      square_meters.emplace (std::lround (point.x()), std::lround (point.y()));
    }
  if (square_meters.empty())
    return std::numeric_limits<double>::infinity();
  return points_inside / static_cast<double> (square_meters.size());
}

/** \brief Numbers of points in the squares of a horizontal grid over a box. */
class CoveredSquares {
public:
  /** \param[in] edge of a square [m]; enlarged if there would be too many squares */
  CoveredSquares (const PlanPoints& points, const Eigen::AlignedBox2d& box, double edge)
  {
    const Eigen::Vector2d sizes = box.sizes();
    edge_ = std::max (edge,
                      std::sqrt (sizes.x() * sizes.y() / constants.max_cover_squares));
    low_ = box.min();
    columns_ = static_cast<std::size_t> (sizes.x() / edge_) + 1;
    rows_ = static_cast<std::size_t> (sizes.y() / edge_) + 1;
    counts_.assign (columns_ * rows_, 0);
    for (const Eigen::Vector3d& point : points)
      if (box.contains (point.head<2>().eval()))
        ++counts_[squareAt (point.head<2>())];
  }

  /** \brief Returns the share of a convex cell whose squares have points, or lie among
   * points farther apart than squares are wide, 0 to 1. */
  double
  coveredShareOf (const PlanCell& cell) const
  {
    return meanOver (cell, [this] (std::size_t square) {
      return counts_[square] > 0 || isAmongSparsePoints (square) ? 1.0 : 0.0;
    });
  }

  /** \brief Returns the density of points in a convex cell [1/m^2]. */
  double
  densityOf (const PlanCell& cell) const
  {
    return meanOver (cell, [this] (std::size_t square) {
      return static_cast<double> (counts_[square]) / (edge_ * edge_);
    });
  }

private:
  /** \brief Returns whether many squares around a square have points, but few each; see
   * sparse_squares_to_side (constants.h). */
  bool
  isAmongSparsePoints (std::size_t square) const
  {
    constexpr std::ptrdiff_t to_side = constants.sparse_squares_to_side;
    const auto middle_column = static_cast<std::ptrdiff_t> (square / rows_);
    const auto middle_row = static_cast<std::ptrdiff_t> (square % rows_);
    const auto columns = static_cast<std::ptrdiff_t> (columns_);
    const auto rows = static_cast<std::ptrdiff_t> (rows_);
    double points = 0.0;
    double squares_with_points = 0.0;
    for (auto column = std::max<std::ptrdiff_t> (0, middle_column - to_side);
         column <= std::min (columns - 1, middle_column + to_side);
         ++column)
      for (auto row = std::max<std::ptrdiff_t> (0, middle_row - to_side);
           row <= std::min (rows - 1, middle_row + to_side);
           ++row) {
        const auto count = counts_[static_cast<std::size_t> (column * rows + row)];
        points += count;
        squares_with_points += count > 0 ? 1.0 : 0.0;
      }
    const double squares_around = (2.0 * to_side + 1.0) * (2.0 * to_side + 1.0);
    return squares_with_points >=
               constants.min_share_of_sparse_squares * squares_around &&
           points < constants.max_points_of_sparse_square * squares_with_points;
  }

  /** \brief Returns the mean, over samples in a cell, of the values of their squares.
   * \param[in] valueOf returns the value of a square from its index into \ref
   * counts_ */
  template <typename Value>
  double
  meanOver (const PlanCell& cell, const Value& valueOf) const
  {
    Eigen::AlignedBox2d box;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& corner : cell.corners) {
      box.extend (corner);
      middle += corner / static_cast<double> (cell.corners.size());
    }
    // Samples on a grid; in a sliver that contains no sample, only its middle.
    constexpr int max_samples = constants.max_samples_of_cell;
    const Eigen::Vector2d squares = (box.sizes() / edge_).array().ceil();
    const int columns = std::clamp (static_cast<int> (squares.x()), 1, max_samples);
    const int rows = std::clamp (static_cast<int> (squares.y()), 1, max_samples);
    int samples = 0;
    double sum = 0.0;
    const auto add_sample = [&] (const Eigen::Vector2d& position) {
      ++samples;
      sum += valueOf (squareAt (position));
    };
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < rows; ++j) {
        const Eigen::Vector2d position =
            box.min() + Eigen::Vector2d ((i + 0.5) / columns * box.sizes().x(),
                                         (j + 0.5) / rows * box.sizes().y());
        if (isWithin (cell, position))
          add_sample (position);
      }
    if (samples == 0)
      add_sample (middle);
    return sum / samples;
  }

  /** \brief Returns whether a position is in a cell or on its border. */
  static bool
  isWithin (const PlanCell& cell, const Eigen::Vector2d& position)
  {
    const std::size_t corners = cell.corners.size();
    for (std::size_t i = 0; i < corners; ++i) {
      const Eigen::Vector2d& from = cell.corners[i];
      if (cross (cell.corners[(i + 1) % corners] - from, position - from) < 0.0)
        return false;
    }
    return true;
  }

  /** \brief Index into \ref counts_ of the square at a position; for a position outside
   * of the box, of the nearest square. */
  std::size_t
  squareAt (const Eigen::Vector2d& position) const
  {
    const Eigen::Vector2d square = ((position - low_) / edge_).array().max (0.0);
    return std::min (columns_ - 1, static_cast<std::size_t> (square.x())) * rows_ +
           std::min (rows_ - 1, static_cast<std::size_t> (square.y()));
  }

  double edge_;         // of a square [m]
  Eigen::Vector2d low_; // corner of the box with the smallest x and y [m]
  std::size_t columns_, rows_;
  std::vector<std::uint32_t> counts_; // points in each square, column by column
};

} // namespace pcl_ops::internal::buildings

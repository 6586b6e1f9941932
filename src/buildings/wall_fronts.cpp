// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wall_fronts.h"

#include "constants.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal::buildings {
namespace {

constexpr double edge = constants.edge_of_side_square;

std::pair<long, long>
squareAt (const Eigen::Vector2d& place)
{
  return {std::lround (place.x() / edge), std::lround (place.y() / edge)};
}

using Squares = std::vector<std::pair<long, long>>;

/** \brief Adds the squares of points; sorted, each once. */
void
addSquares (const PlanPoints& points, Squares& squares)
{
  for (const Eigen::Vector3d& point : points)
    squares.push_back (squareAt (point.head<2>()));
  std::sort (squares.begin(), squares.end());
  squares.erase (std::unique (squares.begin(), squares.end()), squares.end());
}

} // namespace

RoomSides::RoomSides (const std::vector<const PlanPoints*>& level)
{
  for (const PlanPoints* const points : level)
    addSquares (*points, squares_);
}

bool
RoomSides::has (const Eigen::Vector2d& place) const
{
  return std::binary_search (squares_.begin(), squares_.end(), squareAt (place));
}

bool
RoomSides::areBehind (const Eigen::Vector2d& front, const PlanPoints& wall) const
{
  constexpr double beside = constants.beside_wall;
  Squares of_wall;
  addSquares (wall, of_wall);
  std::size_t before = 0;
  std::size_t behind = 0;
  for (const auto& [x, y] : of_wall) {
    const Eigen::Vector2d place =
        edge * Eigen::Vector2d (static_cast<double> (x), static_cast<double> (y));
    before += has (place + beside * front) ? 1 : 0;
    behind += has (place - beside * front) ? 1 : 0;
  }
  return behind > 2 * before + constants.few_side_squares;
}

} // namespace pcl_ops::internal::buildings

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wall_fronts.h"

#include "constants.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_ops::internal::buildings {
namespace {

constexpr double edge = constants.edge_of_side_square;

std::pair<long, long>
squareAt (const Eigen::Vector2d& place)
{
  return {std::lround (place.x() / edge), std::lround (place.y() / edge)};
}

/** \brief The squares of points with the highest of each; sorted, each once. */
std::vector<std::pair<std::pair<long, long>, double>>
highestOfSquares (const std::vector<const PlanPoints*>& lists)
{
  std::vector<std::pair<std::pair<long, long>, double>> squares;
  for (const PlanPoints* const points : lists)
    for (const Eigen::Vector3d& point : *points)
      squares.emplace_back (squareAt (point.head<2>()), -point.z());
  std::sort (squares.begin(), squares.end());
  const auto is_same = [] (const auto& a, const auto& b) { return a.first == b.first; };
  squares.erase (std::unique (squares.begin(), squares.end(), is_same), squares.end());
  for (auto& [square, height] : squares)
    height = -height;
  return squares;
}

} // namespace

RoomSides::RoomSides (const std::vector<const PlanPoints*>& level)
: squares_ (highestOfSquares (level))
{}

std::pair<std::size_t, std::size_t>
RoomSides::countBeside (const Eigen::Vector2d& front,
                        const PlanPoints& wall,
                        double low) const
{
  const auto has = [this, low] (const Eigen::Vector2d& place) {
    const Square square = squareAt (place);
    const auto found = std::lower_bound (
        squares_.begin(), squares_.end(), square, [] (const auto& a, const Square& b) {
          return a.first < b;
        });
    return found != squares_.end() && found->first == square && found->second > low;
  };
  std::pair<std::size_t, std::size_t> beside (0, 0);
  for (const auto& [square, height] : highestOfSquares ({&wall})) {
    const Eigen::Vector2d place =
        edge * Eigen::Vector2d (static_cast<double> (square.first),
                                static_cast<double> (square.second));
    beside.first += has (place + constants.beside_wall * front) ? 1 : 0;
    beside.second += has (place - constants.beside_wall * front) ? 1 : 0;
  }
  return beside;
}

bool
RoomSides::areBehind (const Eigen::Vector2d& front, const PlanPoints& wall) const
{
  constexpr double at_any_height = -std::numeric_limits<double>::infinity();
  const auto [before, behind] = countBeside (front, wall, at_any_height);
  return behind > 2 * before + constants.few_side_squares;
}

bool
RoomSides::goOnOver (const Eigen::Vector2d& front, const PlanPoints& wall) const
{
  double top = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : wall)
    top = std::max (top, point.z());
  const auto [before, behind] = countBeside (front, wall, top + constants.same_level);
  return std::min (before, behind) > constants.few_side_squares &&
         2 * std::min (before, behind) > std::max (before, behind);
}

} // namespace pcl_ops::internal::buildings

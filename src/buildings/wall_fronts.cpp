// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wall_fronts.h"

#include "constants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace pcl_ops::internal::buildings {
namespace {

constexpr double edge = constants.edge_of_side_square;

std::pair<long, long>
squareAt (const Eigen::Vector2d& place)
{
  return {std::lround (place.x() / edge), std::lround (place.y() / edge)};
}

SquaredPoints
pointsBySquare (const std::vector<const PlanPoints*>& lists)
{
  SquaredPoints all;
  for (const PlanPoints* const points : lists)
    for (const Eigen::Vector3d& point : *points)
      all.emplace_back (squareAt (point.head<2>()), point);
  std::sort (all.begin(), all.end(), [] (const auto& a, const auto& b) {
    return std::tie (a.first, a.second.x(), a.second.y(), a.second.z()) <
           std::tie (b.first, b.second.x(), b.second.y(), b.second.z());
  });
  return all;
}

} // namespace

RoomSides::RoomSides (const std::vector<const PlanPoints*>& level)
: points_ (pointsBySquare (level))
{}

bool
RoomSides::hasPointAt (const Eigen::Vector2d& place, double low) const
{
  static_assert (constants.reach_beside_wall <= edge, "the squares next to it will do");
  const auto [x, y] = squareAt (place);
  for (const long column : {x - 1, x, x + 1}) {
    auto point = std::lower_bound (
        points_.begin(),
        points_.end(),
        std::make_pair (column, y - 1),
        [] (const auto& a, const auto& square) { return a.first < square; });
    for (; point != points_.end() && point->first <= std::make_pair (column, y + 1);
         ++point)
      if (point->second.z() > low &&
          (point->second.head<2>() - place).norm() <= constants.reach_beside_wall)
        return true;
  }
  return false;
}

std::pair<std::size_t, std::size_t>
RoomSides::countBeside (const Eigen::Vector2d& front,
                        const PlanPoints& wall,
                        double low) const
{
  std::pair<std::size_t, std::size_t> beside (0, 0);
  double offset = 0.0; // mean place of the points of the wall along front [m]
  for (const Eigen::Vector3d& point : wall)
    offset += front.dot (point.head<2>()) / static_cast<double> (wall.size());
  SquaredPoints places = pointsBySquare ({&wall});
  const auto is_same = [] (const auto& a, const auto& b) { return a.first == b.first; };
  places.erase (std::unique (places.begin(), places.end(), is_same), places.end());
  for (const auto& [square, point] : places) {
    const Eigen::Vector2d place =
        point.head<2>() + (offset - front.dot (point.head<2>())) * front;
    const Eigen::Vector2d off = constants.beside_wall * front;
    beside.first += hasPointAt (place + off, low) ? 1 : 0;
    beside.second += hasPointAt (place - off, low) ? 1 : 0;
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
RoomSides::endAt (const Eigen::Vector2d& front, const PlanPoints& wall) const
{
  constexpr double at_any_height = -std::numeric_limits<double>::infinity();
  const auto [before, behind] = countBeside (front, wall, at_any_height);
  return behind <= std::max (constants.few_side_squares, before / 2);
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

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan/wall_fronts.h"

#include <cmath>

namespace pcl_ops::internal {
namespace {

constexpr double edge = 0.05; // of a square [m]

std::pair<long, long>
squareAt (const Eigen::Vector2d& place)
{
  return {std::lround (place.x() / edge), std::lround (place.y() / edge)};
}

} // namespace

RoomSides::RoomSides (const std::vector<const PlanPoints*>& level)
{
  for (const PlanPoints* const points : level)
    for (const Eigen::Vector3d& point : *points)
      squares_.insert (squareAt (point.head<2>()));
}

bool
RoomSides::has (const Eigen::Vector2d& place) const
{
  return squares_.count (squareAt (place)) > 0;
}

bool
RoomSides::areBehind (const Eigen::Vector2d& front, const PlanPoints& wall) const
{
  // Beyond what noise moves, nearer than the other side of a wall is.
  constexpr double beside = 0.08; // [m]
  constexpr std::size_t few = 3;  // squares
  std::set<std::pair<long, long>> of_wall;
  for (const Eigen::Vector3d& point : wall)
    of_wall.insert (squareAt (point.head<2>()));
  std::size_t before = 0;
  std::size_t behind = 0;
  for (const auto& [x, y] : of_wall) {
    const Eigen::Vector2d place =
        edge * Eigen::Vector2d (static_cast<double> (x), static_cast<double> (y));
    before += has (place + beside * front) ? 1 : 0;
    behind += has (place - beside * front) ? 1 : 0;
  }
  return behind > 2 * before + few;
}

} // namespace pcl_ops::internal

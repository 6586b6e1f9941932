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

constexpr double edge_of_square = constants.edge_of_side_square;
constexpr double any_height = -std::numeric_limits<double>::infinity();

/** \brief Returns all points sorted by square, then by their coordinates. */
std::vector<PointInSquare>
pointsBySquare (const std::vector<const PlanPoints*>& lists)
{
  std::vector<PointInSquare> all;
  for (const PlanPoints* const points : lists)
    for (const Eigen::Vector3d& point : *points)
      all.push_back ({squareAt (point.head<2>(), edge_of_square), point});
  std::sort (all.begin(), all.end(), [] (const auto& a, const auto& b) {
    return std::tie (a.square, a.point.x(), a.point.y(), a.point.z()) <
           std::tie (b.square, b.point.x(), b.point.y(), b.point.z());
  });
  return all;
}

} // namespace

RoomSides::RoomSides (
    const std::vector<const PlanPoints*>& points_of_floors_and_ceilings)
: points_ (pointsBySquare (points_of_floors_and_ceilings))
{}

bool
RoomSides::hasPointAt (const Eigen::Vector2d& position, double low) const
{
  static_assert (constants.reach_beside_wall <= edge_of_square,
                 "points within reach are in the same square or in one next to it");
  const auto [own_column, own_row] = squareAt (position, edge_of_square);
  for (const long column : {own_column - 1, own_column, own_column + 1}) {
    const GridSquare first (column, own_row - 1);
    const GridSquare last (column, own_row + 1);
    auto candidate =
        std::lower_bound (points_.begin(),
                          points_.end(),
                          first,
                          [] (const PointInSquare& point, const GridSquare& square) {
                            return point.square < square;
                          });
    for (; candidate != points_.end() && candidate->square <= last; ++candidate)
      if (candidate->point.z() > low &&
          (candidate->point.head<2>() - position).norm() <= constants.reach_beside_wall)
        return true;
  }
  return false;
}

RoomSides::SamplesBeside
RoomSides::countBeside (const Eigen::Vector2d& front,
                        const PlanPoints& wall,
                        double low) const
{
  SamplesBeside count;
  double mean_along_front = 0.0; // of the wall's points [m]: where its line is
  for (const Eigen::Vector3d& point : wall)
    mean_along_front += front.dot (point.head<2>()) / static_cast<double> (wall.size());
  // One point of each square, moved to the line of the wall, is a sample.
  std::vector<PointInSquare> samples = pointsBySquare ({&wall});
  const auto is_same_square = [] (const PointInSquare& a, const PointInSquare& b) {
    return a.square == b.square;
  };
  samples.erase (std::unique (samples.begin(), samples.end(), is_same_square),
                 samples.end());
  for (const auto& [square, point] : samples) {
    const Eigen::Vector2d on_wall =
        point.head<2>() + (mean_along_front - front.dot (point.head<2>())) * front;
    const Eigen::Vector2d to_front = constants.beside_wall * front;
    count.before += hasPointAt (on_wall + to_front, low) ? 1 : 0;
    count.behind += hasPointAt (on_wall - to_front, low) ? 1 : 0;
  }
  return count;
}

bool
RoomSides::areBehind (const Eigen::Vector2d& front, const PlanPoints& wall) const
{
  const auto [before, behind] = countBeside (front, wall, any_height);
  return behind > 2 * before + constants.few_samples_beside_wall;
}

bool
RoomSides::endAt (const Eigen::Vector2d& front, const PlanPoints& wall) const
{
  const auto [before, behind] = countBeside (front, wall, any_height);
  return behind <= std::max (constants.few_samples_beside_wall, before / 2);
}

bool
RoomSides::goOnOver (const Eigen::Vector2d& front, const PlanPoints& wall) const
{
  double top = -std::numeric_limits<double>::infinity(); // of the wall [m]
  for (const Eigen::Vector3d& point : wall)
    top = std::max (top, point.z());
  const auto [before, behind] =
      countBeside (front, wall, top + constants.min_above_top);
  return std::min (before, behind) > constants.few_samples_beside_wall &&
         2 * std::min (before, behind) > std::max (before, behind);
}

} // namespace pcl_ops::internal::buildings

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "room_graph.h"

#include "constants.h"
#include "planar_area.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl_ops {
namespace {

using namespace internal::buildings;
using Eigen::Vector2d;

/** \brief Returns the index of the first room on the way away from a wall; nothing if
 * there is no room.
 * \param[in] away unit vector
 * \param[in] nearest, farthest limits of the distances from \p on_wall [m]; the
 * first step begins at \p nearest */
std::optional<std::size_t>
firstRoom (const std::vector<PlanRoom>& rooms,
           const Vector2d& on_wall,
           const Vector2d& away,
           double nearest,
           double farthest)
{
  const long steps = std::lround ((farthest - nearest) / constants.step_to_room);
  for (long step = 1; step <= steps; ++step) {
    const double distance =
        nearest + static_cast<double> (step) * constants.step_to_room;
    for (std::size_t i = 0; i < rooms.size(); ++i)
      if (isInRoom (rooms[i], on_wall + distance * away))
        return i;
  }
  return {};
}

} // namespace

namespace internal::buildings {

bool
isInRoom (const PlanRoom& room, const Vector2d& position)
{
  return !room.rings.empty() && isWithinRing (room.rings.front(), position) &&
         std::none_of (
             room.rings.begin() + 1, room.rings.end(), [&] (const auto& hole) {
               return isWithinRing (hole, position);
             });
}

void
findRoomsOfOpenings (const std::vector<PlanRoom>& rooms, std::vector<PlanWall>& walls)
{
  for (PlanWall& wall : walls) {
    const Vector2d along = (wall.to - wall.from).normalized();
    const Vector2d to_front (-along.y(), along.x()); // the front is on the left
    // Behind a wall of unknown thickness the search begins at the wall.
    const double thickness = wall.thickness.value_or (0.0);
    const double farthest_behind =
        wall.thickness ? thickness + constants.max_to_room : constants.max_thickness;
    for (PlanOpening& opening : wall.openings) {
      const Vector2d middle = 0.5 * (opening.from + opening.to);
      opening.room_before =
          firstRoom (rooms, middle, to_front, 0.0, constants.max_to_room);
      opening.room_behind =
          firstRoom (rooms, middle, -to_front, thickness, farthest_behind);
    }
  }
}

} // namespace internal::buildings

bool
PlanOpening::isDoor() const
{
  return !sill || *sill < constants.max_threshold;
}

std::vector<std::size_t>
FloorPlan::roomsBehindDoorsOf (std::size_t room) const
{
  std::vector<std::size_t> neighbors;
  for (const PlanWall& wall : walls)
    for (const PlanOpening& opening : wall.openings) {
      const std::optional<std::size_t>& before = opening.room_before;
      const std::optional<std::size_t>& behind = opening.room_behind;
      if (!opening.isDoor() || !before || !behind || *before == *behind)
        continue;
      if (*before == room)
        neighbors.push_back (*behind);
      if (*behind == room)
        neighbors.push_back (*before);
    }
  std::sort (neighbors.begin(), neighbors.end());
  neighbors.erase (std::unique (neighbors.begin(), neighbors.end()), neighbors.end());
  return neighbors;
}

} // namespace pcl_ops

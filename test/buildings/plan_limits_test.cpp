// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Limits at which floor plans change, each tested from both sides.
#include "building.h"

#include <cmath>
#include <functional>
#include <string>

namespace {

/** \brief A limit of a quantity, and how many parts a plan has below it and above it.
 */
struct PlanLimit {
  std::string of;
  /** \brief Values of the quantity a little below and a little above the limit. */
  double below, above;
  std::size_t number_below, number_above;
  /** \brief Returns the number of parts for a value of the quantity. */
  std::function<std::size_t (double)> number;
};

/** \brief Fails unless the numbers below and above each limit are these. */
void
expectPlanLimits (const std::vector<PlanLimit>& limits)
{
  for (const PlanLimit& limit : limits) {
    EXPECT_EQ (limit.number (limit.below), limit.number_below) << limit.of;
    EXPECT_EQ (limit.number (limit.above), limit.number_above) << limit.of;
  }
}

/** \brief Adds a piece of furniture: a rectangle with a corner and two edges from it.
 */
Building&
addPiece (Building& building,
          const Vector3d& normal,
          const Vector3d& corner,
          const Vector3d& first,
          const Vector3d& second)
{
  std::vector<Vector3d> points;
  for (double s = half_spacing; s < first.norm(); s += grid_spacing)
    for (double t = half_spacing; t < second.norm(); t += grid_spacing)
      points.push_back (corner + s * first.normalized() + t * second.normalized());
  return building.add (PlaneKind::Other, normal, points);
}

/** \brief Four walls around 4 m x 3 m. */
Building
fourWalls ()
{
  Building walls;
  walls.wall ({0, 0}, {4, 0}).wall ({4, 0}, {4, 3});
  return walls.wall ({4, 3}, {0, 3}).wall ({0, 3}, {0, 0});
}

/** \brief Number of walls of which both sides were seen. */
std::size_t
thickWallsOf (const FloorPlan& plan)
{
  std::size_t thick = 0;
  for (const PlanWall& wall : plan.walls)
    thick += wall.thickness ? 1 : 0;
  return thick;
}

} // namespace

TEST (PlanLimits, OfPartsOfOneWall)
{
  const auto wallsOfParts = [] (double meters) {
    Building parts;
    parts.wall ({0, 0}, {2, 0}).wall ({2, meters}, {4, meters});
    return parts.plan().walls.size();
  };
  const auto wallsOfTurnedParts = [] (double degrees) {
    const Vector2d along (std::cos (degrees * 1_deg), std::sin (degrees * 1_deg));
    Building parts;
    parts.wall ({0, 0}, {2, 0}).wall ({2, 0}, Vector2d (2, 0) + 0.6 * along);
    return parts.plan().walls.size();
  };
  expectPlanLimits (
      {{"distance", 4_cm, 6_cm, 1, 2, wallsOfParts},
       {"angle, which is 4 degrees", 3.5, 4.5, 1, 2, wallsOfTurnedParts}});
}

TEST (PlanLimits, OfWallsThatMeet)
{
  // A wall that ends 20 cm before another one is drawn to it, unless they are nearly
  // parallel.
  const auto wallsDrawnToCorner = [] (double degrees) {
    const Vector2d along (std::cos (degrees * 1_deg), std::sin (degrees * 1_deg));
    const Vector2d meeting_point (3, 0);
    Building walls;
    walls.wall ({0, 0}, {6, 0})
        .wall (meeting_point + 0.2 * along, meeting_point + 3.0 * along);
    return walls.plan().walls.at (1).length() > 2.9 ? 1u : 0u;
  };
  expectPlanLimits ({{"15 degrees", 13.0, 17.0, 0, 1, wallsDrawnToCorner}});
}

TEST (PlanLimits, OfWallsThatAreSeenAtTheCut)
{
  const auto wallsSeenFor = [] (double meters) {
    Building hidden; // the floor goes on below the wall, which may be a lintel
    hidden.level (PlaneKind::Floor, 0.0, {0, -2}, {4, 2});
    hidden.wall ({0, 0}, {4, 0}, {{meters, 4.0, 0.5, 2.0}});
    return hidden.plan().walls.size();
  };
  expectPlanLimits ({{"a quarter of its length", 0.9, 1.1, 0, 1, wallsSeenFor}});
}

TEST (PlanLimits, OfTheTwoSidesOfAWall)
{
  const auto thickWallsApart = [] (double meters) {
    Building wall;
    wall.wall ({0, 0}, {4, 0}).wall ({4, -meters}, {0, -meters});
    return thickWallsOf (wall.plan());
  };
  const auto thickWallsBeside = [] (double meters) {
    Building wall;
    wall.wall ({0, 0}, {4, 0}).wall ({8.0 - meters, -0.2}, {4.0 - meters, -0.2});
    return thickWallsOf (wall.plan());
  };
  expectPlanLimits ({{"thickest, 0.7 m", 0.65, 0.75, 2, 0, thickWallsApart},
                     {"30 cm beside each other", 0.25, 0.45, 0, 2, thickWallsBeside}});
}

TEST (PlanLimits, OfWhatHidesADoor)
{
  const auto openingsBehind = [] (double meters) {
    Building room = roomOf4By3();
    addPiece (room, Vector3d::UnitY(), {0.9, meters, 0}, {1.1, 0, 0}, {0, 0, 2});
    return openingsOf (room.plan());
  };
  const auto openingsBelow = [] (double over_cut) {
    Building room = roomOf4By3();
    const Vector3d corner (0.9, 0.4, 1.2 + over_cut - 0.025);
    addPiece (room, Vector3d::UnitY(), corner, {1.1, 0, 0}, {0, 0, 0.5});
    return openingsOf (room.plan());
  };
  const auto openingsBefore = [] (double meters) {
    Building room = roomOf4By3();
    // Level, so that it is no leaf.
    const Vector3d corner (0.9, -meters - 0.025, 1.2);
    addPiece (room, Vector3d::UnitZ(), corner, {1.1, 0, 0}, {0, 0.04, 0});
    return openingsOf (room.plan());
  };
  expectPlanLimits ({{"80 cm before it", 0.75, 0.85, 0, 1, openingsBehind},
                     {"10 cm over the cut", 0.08, 0.12, 0, 1, openingsBelow},
                     {"5 cm within the wall", 0.04, 0.06, 0, 1, openingsBefore}});
}

TEST (PlanLimits, OfTheLowestFloor)
{
  // A pit of some square meters beside a floor of 12: the cut is 1.2 m over the pit or
  // over the floor.
  const auto cutsInPit = [] (double width) {
    Building hall = roomOf4By3();
    hall.level (PlaneKind::Floor, -1.0, {10, 0}, {12, width});
    return hall.plan().height < 1_m ? 1u : 0u;
  };
  expectPlanLimits ({{"a fifth of the floor", 1.1, 1.3, 0, 1, cutsInPit}});
}

TEST (PlanLimits, OfWhatCoversARoom)
{
  const auto roomsOver = [] (double below) {
    Building room = fourWalls();
    room.level (PlaneKind::Floor, 0.0, {9, 9}, {11, 11});
    room.level (PlaneKind::Slab, -below, {0, 0}, {4, 3});
    return room.plan().rooms.size();
  };
  const auto roomsUnder = [] (double over_cut) {
    Building room = fourWalls();
    room.level (PlaneKind::Ceiling, 1.225 + over_cut, {0, 0}, {4, 3});
    return room.plan().rooms.size();
  };
  const auto roomsOfWidth = [] (double width) {
    Building corridor;
    corridor.level (PlaneKind::Floor, 0.0, {0, 0}, {6, width});
    corridor.wall ({0, 0}, {6, 0}).wall ({6, 0}, {6, width});
    corridor.wall ({6, width}, {0, width}).wall ({0, width}, {0, 0});
    return corridor.plan().rooms.size();
  };
  expectPlanLimits ({{"60 cm below the floor", 0.55, 0.65, 1, 0, roomsOver},
                     {"6 m over the cut", 5.9, 6.1, 1, 0, roomsUnder},
                     {"some 35 cm wide", 0.3, 0.45, 0, 1, roomsOfWidth}});
}

TEST (PlanLimits, OfRoofsBesideTheWalls)
{
  // A piece that slopes in the middle of a room, two meters from all walls.
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {8, 6});
  std::vector<Vector3d> piece;
  for (double x = 2.0; x <= 6.0; x += 10_cm)
    for (double y = 2.0; y <= 4.0; y += 10_cm)
      piece.emplace_back (x, y, 2.2 + 0.3 * y);
  room.add (PlaneKind::Roof, Vector3d (0.0, -0.3, 1.0).normalized(), piece);
  room.wall ({0, 0}, {8, 0}).wall ({8, 0}, {8, 6});
  room.wall ({8, 6}, {0, 6}).wall ({0, 6}, {0, 0});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 48.0, 0.01);
  EXPECT_TRUE (plan.rooms[0].floor);
}

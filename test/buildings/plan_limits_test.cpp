// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Limits at which floor plans change, each tested from both sides.
#include "building.h"

#include <cmath>
#include <functional>
#include <string>

namespace {

/** \brief Height of the cut [m]: the default of FloorPlanParameters::cut_height, over a
 * floor at height 0. */
constexpr double cut_height = 1.2;

/** \brief A limit of a quantity, and how many walls, openings or rooms a plan has for
 * values below it and above it. */
struct PlanLimit {
  std::string quantity;
  /** \brief Values of the quantity a little below and a little above the limit, in
   * meters or degrees. */
  double below, above;
  std::size_t number_below, number_above;
  /** \brief Returns the number for a value of the quantity. */
  std::function<std::size_t (double)> numberFor;
};

/** \brief Fails unless the numbers below and above each limit are these. */
void
expectPlanLimits (const std::vector<PlanLimit>& limits)
{
  for (const PlanLimit& limit : limits) {
    EXPECT_EQ (limit.numberFor (limit.below), limit.number_below) << limit.quantity;
    EXPECT_EQ (limit.numberFor (limit.above), limit.number_above) << limit.quantity;
  }
}

/** \brief Adds a piece of furniture: a rectangle with a corner and two edge vectors
 * from it [m]. */
Building&
addPiece (Building& building,
          const Vector3d& normal,
          const Vector3d& corner,
          const Vector3d& first,
          const Vector3d& second)
{
  std::vector<Vector3d> points;
  for (double along_first = half_spacing; along_first < first.norm();
       along_first += grid_spacing)
    for (double along_second = half_spacing; along_second < second.norm();
         along_second += grid_spacing)
      points.push_back (corner + along_first * first.normalized() +
                        along_second * second.normalized());
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

/** \brief Number of walls of a plan with a thickness: sides of a real wall whose other
 * side was seen, too. */
std::size_t
sidesOfThickWalls (const FloorPlan& plan)
{
  std::size_t sides = 0;
  for (const PlanWall& side : plan.walls)
    sides += side.thickness ? 1 : 0;
  return sides;
}

} // namespace

TEST (PlanLimits, OfPartsOfOneWall)
{
  // Two parallel walls, the second one behind the end of the first and this far beside
  // it.
  const auto wallsApart = [] (double distance) {
    Building parts;
    parts.wall ({0, 0}, {2, 0}).wall ({2, distance}, {4, distance});
    return parts.plan().walls.size();
  };
  // A wall, and at its end a shorter one in a direction turned by an angle.
  const auto wallsTurned = [] (double degrees) {
    const Vector2d along (std::cos (degrees * 1_deg), std::sin (degrees * 1_deg));
    Building parts;
    parts.wall ({0, 0}, {2, 0}).wall ({2, 0}, Vector2d (2, 0) + 0.6 * along);
    return parts.plan().walls.size();
  };
  expectPlanLimits ({{"distance, at most 5 cm", 4_cm, 6_cm, 1, 2, wallsApart},
                     {"angle, at most 4 degrees", 3.5, 4.5, 1, 2, wallsTurned}});
}

TEST (PlanLimits, OfWallsThatMeet)
{
  // A wall that ends 20 cm before another one is drawn to it, unless they are nearly
  // parallel.
  const auto wallsDrawnToTheOther = [] (double degrees) {
    const Vector2d along (std::cos (degrees * 1_deg), std::sin (degrees * 1_deg));
    const Vector2d meeting_point (3, 0);
    Building walls;
    walls.wall ({0, 0}, {6, 0})
        .wall (meeting_point + 0.2 * along, meeting_point + 3.0 * along);
    const bool is_drawn = walls.plan().walls.at (1).length() > 2.9; // 2.8 m were seen
    return is_drawn ? 1u : 0u;
  };
  expectPlanLimits (
      {{"angle, at least 15 degrees", 13.0, 17.0, 0, 1, wallsDrawnToTheOther}});
}

TEST (PlanLimits, OfWallsThatAreSeenAtTheCut)
{
  // A wall of 4 m of which only this length was seen at the cut. The floor is on both
  // sides of the wall, so that it may be a lintel over an open passage.
  const auto wallsSeenFor = [] (double seen_length) {
    Building hidden;
    hidden.level (PlaneKind::Floor, 0.0, {0, -2}, {4, 2});
    hidden.wall ({0, 0}, {4, 0}, {{seen_length, 4.0, 0.5, 2.0}});
    return hidden.plan().walls.size();
  };
  expectPlanLimits (
      {{"seen length, a quarter of the wall", 0.9, 1.1, 0, 1, wallsSeenFor}});
}

TEST (PlanLimits, OfTheTwoSidesOfAWall)
{
  // Two sides of a wall at a distance from each other.
  const auto thickSidesApart = [] (double thickness) {
    Building wall;
    wall.wall ({0, 0}, {4, 0}).wall ({4, -thickness}, {0, -thickness});
    return sidesOfThickWalls (wall.plan());
  };
  // Two sides 20 cm apart that are opposite each other for a part of their length.
  const auto thickSidesThatOverlap = [] (double overlap) {
    Building wall;
    wall.wall ({0, 0}, {4, 0}).wall ({8.0 - overlap, -0.2}, {4.0 - overlap, -0.2});
    return sidesOfThickWalls (wall.plan());
  };
  expectPlanLimits (
      {{"thickness, at most 70 cm", 0.65, 0.75, 2, 0, thickSidesApart},
       {"overlap, at least 30 cm", 0.25, 0.45, 0, 2, thickSidesThatOverlap}});
}

TEST (PlanLimits, OfWhatHidesADoor)
{
  // An upright piece in the room, this far before the door.
  const auto openingsBehindAPiece = [] (double distance) {
    Building room = roomOf4By3();
    addPiece (room, Vector3d::UnitY(), {0.9, distance, 0}, {1.1, 0, 0}, {0, 0, 2});
    return numberOfOpenings (room.plan());
  };
  // An upright piece before the door whose lowest points are this far above the cut.
  const auto openingsBelowAPiece = [] (double over_cut) {
    Building room = roomOf4By3();
    const Vector3d corner (0.9, 0.4, cut_height + over_cut - half_spacing);
    addPiece (room, Vector3d::UnitY(), corner, {1.1, 0, 0}, {0, 0, 0.5});
    return numberOfOpenings (room.plan());
  };
  // A level piece, which is no leaf, in the door, this far behind the front of the
  // wall.
  const auto openingsBeforeAPiece = [] (double depth) {
    Building room = roomOf4By3();
    const Vector3d corner (0.9, -depth - half_spacing, cut_height);
    addPiece (room, Vector3d::UnitZ(), corner, {1.1, 0, 0}, {0, 0.04, 0});
    return numberOfOpenings (room.plan());
  };
  expectPlanLimits (
      {{"distance, at most 80 cm", 0.75, 0.85, 0, 1, openingsBehindAPiece},
       {"height over the cut, at most 10 cm", 0.08, 0.12, 0, 1, openingsBelowAPiece},
       {"depth, at most 5 cm", 0.04, 0.06, 0, 1, openingsBeforeAPiece}});
}

TEST (PlanLimits, OfTheLowestFloor)
{
  // A pit, 2 m long and 1 m deep, beside a floor of 12 m^2. The cut is 1.2 m over the
  // pit (1) or over the floor (0).
  const auto cutsOverPit = [] (double width) {
    Building hall = roomOf4By3();
    hall.level (PlaneKind::Floor, -1.0, {10, 0}, {12, width});
    return hall.plan().height < 1_m ? 1u : 0u;
  };
  expectPlanLimits (
      {{"width of the pit, a fifth of the floor's area", 1.1, 1.3, 0, 1, cutsOverPit}});
}

TEST (PlanLimits, OfWhatCoversARoom)
{
  // A room over a slab that is this far below the lowest floor, which is outside of it.
  const auto roomsOverSlab = [] (double below) {
    Building room = fourWalls();
    room.level (PlaneKind::Floor, 0.0, {9, 9}, {11, 11});
    room.level (PlaneKind::Slab, -below, {0, 0}, {4, 3});
    return room.plan().rooms.size();
  };
  // A room under a ceiling this far above the cut. Without a floor the cut is 1.2 m
  // over the lowest points of the walls.
  const auto roomsUnderCeiling = [] (double over_cut) {
    Building room = fourWalls();
    const double height = half_spacing + cut_height + over_cut;
    room.level (PlaneKind::Ceiling, height, {0, 0}, {4, 3});
    return room.plan().rooms.size();
  };
  // A corridor of 6 m.
  const auto roomsOfWidth = [] (double width) {
    Building corridor;
    corridor.level (PlaneKind::Floor, 0.0, {0, 0}, {6, width});
    corridor.wall ({0, 0}, {6, 0}).wall ({6, 0}, {6, width});
    corridor.wall ({6, width}, {0, width}).wall ({0, width}, {0, 0});
    return corridor.plan().rooms.size();
  };
  expectPlanLimits (
      {{"depth below the floor, at most 60 cm", 0.55, 0.65, 1, 0, roomsOverSlab},
       {"height over the cut, at most 6 m", 5.9, 6.1, 1, 0, roomsUnderCeiling},
       {"width, at least some 35 cm", 0.3, 0.45, 0, 1, roomsOfWidth}});
}

TEST (PlanLimits, OfRoofsBesideTheWalls)
{
  // A building stands under roofs if most of its walls are under them or within some 1
  // m of them. This sloping plane in the middle of a room is two meters from all walls,
  // so that the room goes on beside it.
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

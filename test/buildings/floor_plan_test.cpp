// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "building.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace {

/** \brief The points of a grid, 5 cm apart, on an upright rectangle at this y.
 * \param[in] low,high smallest and largest x and z [m] */
std::vector<Vector3d>
uprightAlongX (double y, const Vector2d& low, const Vector2d& high)
{
  std::vector<Vector3d> points;
  for (double x = low.x(); x < high.x(); x += grid_spacing)
    for (double z = low.y(); z < high.y(); z += grid_spacing)
      points.emplace_back (x, y, z);
  return points;
}

/** \brief Adds a floor whose points are 15 cm apart. */
void
addSparseFloor (Building& building, const Vector2d& low, const Vector2d& high)
{
  std::vector<Vector3d> points;
  for (double x = low.x() + 7_cm; x < high.x(); x += 15_cm)
    for (double y = low.y() + 7_cm; y < high.y(); y += 15_cm)
      points.emplace_back (x, y, 0.0);
  building.add (PlaneKind::Floor, Vector3d::UnitZ(), points);
}

/** \brief Returns a building turned about the vertical.
 * \param[in] angle counter-clockwise [rad] */
Building
turnedBy (double angle, Building building)
{
  const Eigen::AngleAxisd turn (angle, Vector3d::UnitZ());
  for (pcl::PointXYZ& point : building.cloud)
    point = toPoint (turn * point.getVector3fMap().cast<double>());
  for (PlaneSegment& plane : building.planes) {
    plane.centroid = turn * plane.centroid;
    plane.normal = turn * plane.normal;
  }
  return building;
}

/** \brief Length of all walls together [m]. */
double
sumOfLengths (const FloorPlan& plan)
{
  double sum = 0.0;
  for (const PlanWall& wall : plan.walls)
    sum += wall.length();
  return sum;
}

} // namespace

TEST (FloorPlan, OfARoomOf4By3MetersHasFourWallsADoorAnd12SquareMeters)
{
  const FloorPlan plan = roomOf4By3().plan();
  ASSERT_EQ (plan.walls.size(), 4u);
  EXPECT_NEAR (sumOfLengths (plan), 14_m, 1_mm) << "from corner to corner";
  ASSERT_EQ (numberOfOpenings (plan), 1u);
  const PlanOpening& found_door = plan.walls[0].openings.at (0);
  EXPECT_NEAR (found_door.width(), 0.9_m, 6_cm);
  EXPECT_NEAR (found_door.from.x(), 1_m, 3_cm);
  EXPECT_FALSE (found_door.sill);
  EXPECT_NEAR (found_door.head.value_or (0.0), 2.05, 6_cm);
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.01);
  EXPECT_EQ (plan.rooms[0].rings.at (0).size(), 4u);
  EXPECT_NEAR (
      plan.rooms[0].ceiling.value() - plan.rooms[0].floor.value(), 2.5_m, 1_mm);
  EXPECT_NEAR (plan.height, 1.2_m, 1_mm);
}

TEST (FloorPlan, HasWallsWithTheirOwnPlanesAlone)
{
  // Two rooms 7 m apart, whose walls are on the same lines.
  Building building;
  for (const double x : {0.0, 10.0}) {
    building.level (PlaneKind::Floor, 0.0, {x, 0}, {x + 3, 3});
    building.wall ({x, 0}, {x + 3, 0}).wall ({x + 3, 0}, {x + 3, 3});
    building.wall ({x + 3, 3}, {x, 3}).wall ({x, 3}, {x, 0});
  }
  const FloorPlan plan = building.plan();
  ASSERT_EQ (plan.walls.size(), 8u);
  for (const PlanWall& wall : plan.walls)
    EXPECT_EQ (wall.planes.size(), 1u);
}

TEST (FloorPlan, HasTheHeightOfACorridorApartFromThatOfTheLargerRoomInsideIt)
{
  // A corridor 1 m wide around a core of 8 m x 8 m, whose floor is 20 cm higher.
  Building building;
  building.level (PlaneKind::Floor, 0.0, {0, 0}, {10, 1});
  building.level (PlaneKind::Floor, 0.0, {0, 9}, {10, 10});
  building.level (PlaneKind::Floor, 0.0, {0, 1}, {1, 9});
  building.level (PlaneKind::Floor, 0.0, {9, 1}, {10, 9});
  building.level (PlaneKind::Floor, 0.2, {1.2, 1.2}, {8.8, 8.8});
  building.wall ({0, 0}, {10, 0}).wall ({10, 0}, {10, 10});
  building.wall ({10, 10}, {0, 10}).wall ({0, 10}, {0, 0});
  building.wall ({1, 1}, {1, 9}).wall ({1, 9}, {9, 9}); // outer sides of the core
  building.wall ({9, 9}, {9, 1}).wall ({9, 1}, {1, 1});
  building.wall ({1.2, 1.2}, {8.8, 1.2}).wall ({8.8, 1.2}, {8.8, 8.8});
  building.wall ({8.8, 8.8}, {1.2, 8.8}).wall ({1.2, 8.8}, {1.2, 1.2});
  const FloorPlan plan = building.plan();
  ASSERT_EQ (plan.rooms.size(), 2u);
  const PlanRoom& core = plan.rooms[0];
  const PlanRoom& corridor = plan.rooms[1];
  ASSERT_EQ (corridor.rings.size(), 2u) << "with a hole";
  EXPECT_NEAR (core.floor.value(), 0.2, 1_mm);
  EXPECT_NEAR (corridor.floor.value(), 0.0, 1_mm);
  for (const PlanRoom& room : plan.rooms)
    EXPECT_LE (room.enclosed, 1.0);
}

TEST (FloorPlan, HasTheHeightOfMostOfTheFloorWhereverMostPointsAre)
{
  Building room = roomOf4By3();
  // A corner of the floor, near the sensor, that drift has lowered.
  std::vector<Vector3d> dense; // a square meter with more points than the whole floor
  for (double x = 0.005; x < 1.0; x += 1_cm)
    for (double y = 0.005; y < 1.0; y += 1_cm)
      dense.emplace_back (x, y, -4_cm);
  room.add (PlaneKind::Floor, Vector3d::UnitZ(), dense);

  const FloorPlan plan = room.plan();

  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].floor.value(), 0.0, 1_mm);
}

TEST (FloorPlan, OfAWallWithAWindowSaysWhereItsSillAndHeadAre)
{
  Building house = roomOf4By3(); // has four walls; that with the window is the fifth
  house.wall ({0, 9}, {4, 9}, {window});
  const FloorPlan plan = house.plan();
  const PlanOpening& found_window = plan.walls.at (4).openings.at (0);
  EXPECT_NEAR (found_window.width(), 1.5_m, 6_cm);
  EXPECT_NEAR (found_window.sill.value_or (0.0), 0.9_m, 6_cm);
  EXPECT_NEAR (found_window.head.value_or (0.0), 2.1_m, 6_cm);
}

TEST (FloorPlan, OfAnUpperStoryHasSillsOverItsFloor)
{
  Building house = roomOf4By3();
  house.wall ({0, 9}, {4, 9}, {window});
  for (pcl::PointXYZ& point : house.cloud)
    point.z += 6.0f;
  for (PlaneSegment& plane : house.planes)
    plane.moveBy ({0, 0, 6});
  const FloorPlan plan = house.plan();
  const PlanOpening& found_window = plan.walls.at (4).openings.at (0);
  EXPECT_NEAR (found_window.sill.value_or (0.0), 0.9_m, 6_cm);
  EXPECT_NEAR (found_window.head.value_or (0.0), 2.1_m, 6_cm);
}

TEST (FloorPlan, HasSolidPartsOfWallsBesideOpenings)
{
  const auto parts = roomOf4By3().plan().walls.at (0).solidParts();
  ASSERT_EQ (parts.size(), 2u);
  const auto& [begin_of_wall, begin_of_door] = parts[0];
  const auto& [end_of_door, end_of_wall] = parts[1];
  EXPECT_NEAR (begin_of_door.x(), 1_m, 3_cm);
  EXPECT_NEAR (end_of_door.x(), 1.9_m, 3_cm);
  EXPECT_NEAR (end_of_wall.x(), 4_m, 1_mm);
}

TEST (FloorPlan, HasNoDoorThatEndsBelowTheCut)
{
  FloorPlanParameters above_door; // which ends at 2.05 m
  above_door.cut_height = 2.3_m;
  const FloorPlan plan = roomOf4By3().plan (above_door);
  EXPECT_EQ (plan.walls.size(), 4u);
  EXPECT_EQ (numberOfOpenings (plan), 0u);
}

TEST (FloorPlan, OfARoomWithACupboardAtItsWallIsThatOfTheRoom)
{
  // The front of the cupboard is 2 m high and 62 cm before the wall at x = 4 m.
  Building room = roomOf4By3();
  std::vector<Vector3d> front;
  for (double y = 0.025; y < 3.0; y += 5_cm)
    for (double z = 0.025; z < 2.0; z += 5_cm)
      front.emplace_back (3.38, y, z);
  room.add (PlaneKind::Wall, {-1.0, 0.0, 0.0}, front);
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.01);
  EXPECT_EQ (plan.walls.size(), 4u);
}

TEST (FloorPlan, HasNoOpeningBehindFurniture)
{
  // A piece before the door may hide a part of the wall.
  Building furnished = roomOf4By3();
  furnished.add (
      PlaneKind::Other, Vector3d::UnitY(), uprightAlongX (0.4, {0.9, 0.0}, {2.0, 2.0}));
  const FloorPlan plan = furnished.plan();
  EXPECT_EQ (plan.walls.size(), 4u);
  EXPECT_EQ (numberOfOpenings (plan), 0u);
}

TEST (FloorPlan, HasAnOpeningBehindFurnitureWhereAnythingIsSeenThroughIt)
{
  Building furnished = roomOf4By3();
  for (const double y : {0.4, -0.4}) { // before the door and in the next room
    // Its normal is not level, so that it is no leaf of the door.
    furnished.add (PlaneKind::Other,
                   Vector3d (0, 1, 1).normalized(),
                   uprightAlongX (y, {0.9, 0.0}, {2.0, 2.0}));
  }
  EXPECT_EQ (numberOfOpenings (furnished.plan()), 1u);
}

TEST (FloorPlan, HasNoThicknessBetweenWallsThatFaceTheSameWay)
{
  Building walls;
  walls.wall ({0, 0}, {4, 0}).wall ({0, -0.2}, {4, -0.2});
  const FloorPlan plan = walls.plan();
  ASSERT_EQ (plan.walls.size(), 2u);
  for (const PlanWall& wall : plan.walls)
    EXPECT_FALSE (wall.thickness);
}

TEST (FloorPlan, HasAnOpeningWhereALeafIsSetBack)
{
  Building closed = roomOf4By3();
  closed.wall ({1.0, -0.1}, {1.9, -0.1}); // the leaf of the door
  const FloorPlan plan = closed.plan();
  EXPECT_EQ (plan.walls.size(), 4u);
  EXPECT_EQ (numberOfOpenings (plan), 1u);
}

TEST (FloorPlan, HasAnOpeningWhereALeafIsSetBackByLessThanTheDepthOfWhatHides)
{
  // Points up to 5 cm behind a gap hide it (max_depth_of_hiding). This leaf is 3 cm
  // behind: as a leaf it does not.
  Building closed = roomOf4By3();
  const std::vector<Vector3d> leaf = uprightAlongX (-0.03, {1.025, 0.025}, {1.9, 2.05});
  closed.add (PlaneKind::Other, Vector3d::UnitY(), leaf);
  EXPECT_EQ (numberOfOpenings (closed.plan()), 1u);
}

TEST (FloorPlan, HasAnOpeningWhereALeafNamedWallIsSetBackByLessThanPartsOfOneWall)
{
  Building closed = roomOf4By3();
  const std::vector<Vector3d> leaf = uprightAlongX (-0.03, {1.025, 0.025}, {1.9, 2.05});
  closed.add (PlaneKind::Wall, Vector3d::UnitY(), leaf);
  const FloorPlan plan = closed.plan();
  EXPECT_EQ (plan.walls.size(), 4u);
  EXPECT_EQ (numberOfOpenings (plan), 1u);
}

TEST (FloorPlan, HasAllOfAnOpeningWhereACounterBeforeItTouchesTheWall)
{
  // A window from x = 1 m to 2.5 m, with a pane. A counter at the height of the cut has
  // its back edge in the plane of the wall: from x = 1.4 m to 2.1 m there are points in
  // the window.
  Building room;
  room.wall ({0, 0},
             {4, 0},
             {{1.0, 2.5, 0.9, 1.1},
              {1.0, 2.5, 1.3, 2.1},
              {1.0, 1.4, 1.0, 1.4},
              {2.1, 2.5, 1.0, 1.4}});
  const std::vector<Vector3d> pane = uprightAlongX (-0.2, {1.025, 0.925}, {2.5, 2.1});
  room.add (PlaneKind::Other, Vector3d::UnitY(), pane);
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.walls.size(), 1u);
  ASSERT_EQ (plan.walls[0].openings.size(), 1u);
  EXPECT_NEAR (plan.walls[0].openings[0].width(), 1.5, 0.06);
}

TEST (FloorPlan, HasNoOpeningWhereAnotherPlaneFillsTheGap)
{
  // The back of a cupboard, 2 cm before the wall.
  Building room;
  room.wall ({0, 0}, {4, 0}, {{1.0, 2.5, 0.0, 2.1}});
  const std::vector<Vector3d> back = uprightAlongX (0.02, {1.025, 0.025}, {2.5, 2.1});
  room.add (PlaneKind::Other, Vector3d::UnitY(), back);
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  const FloorPlan plan = room.plan();
  EXPECT_EQ (plan.walls.size(), 1u);
  EXPECT_EQ (numberOfOpenings (plan), 0u);
}

TEST (FloorPlan, HasNoRoomBetweenTheTwoSidesOfAWall)
{
  // Two rooms of 7 m x 3 m. The wall between them is 7 m long, and the floors end
  // exactly at its sides.
  for (const double thickness : {0.15, 0.3}) {
    Building flat;
    for (const double y : {0.0, 3.0 + thickness}) {
      flat.level (PlaneKind::Floor, 0.0, {0, y}, {7, y + 3});
      flat.wall ({0, y}, {7, y}).wall ({7, y}, {7, y + 3});
      flat.wall ({7, y + 3}, {0, y + 3}).wall ({0, y + 3}, {0, y});
    }
    FloorPlanParameters parameters;
    parameters.min_room = 0.5;
    const FloorPlan plan = flat.plan (parameters);
    ASSERT_EQ (plan.rooms.size(), 2u) << thickness;
    EXPECT_NEAR (plan.rooms[1].area, 21.0, 0.01);
  }
}

TEST (FloorPlan, HasNoOpeningWhereTheOtherSideOfAWallWasSeen)
{
  // A wall without a gap. Of its other side 2 m were seen: these are no leaf in a gap.
  Building flat;
  flat.wall ({0, 0}, {4, 0}).wall ({3, -0.1}, {1, -0.1});
  const FloorPlan plan = flat.plan();
  EXPECT_FALSE (plan.walls.empty());
  EXPECT_EQ (numberOfOpenings (plan), 0u);
}

TEST (FloorPlan, DrawsEndsOfWallsToTheirCommonCorners)
{
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  // Furniture hides 20 cm at both ends of each wall.
  room.wall ({0.2, 0}, {3.8, 0}).wall ({4, 0.2}, {4, 2.8});
  room.wall ({3.8, 3}, {0.2, 3}).wall ({0, 2.8}, {0, 0.2});
  const FloorPlan plan = room.plan();
  EXPECT_NEAR (sumOfLengths (plan), 14_m, 1_mm);
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.01);
}

TEST (FloorPlan, HasNoOpeningWhereAnEndIsDrawnToACornerOverLessThanAnOpening)
{
  // Furniture hides the first 0.3 m of a wall, and at the cut 0.2 m more.
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  room.wall ({0.3, 0}, {4, 0}, {{0.0, 0.2, 0.5, 2.0}}).wall ({4, 0}, {4, 3});
  room.wall ({4, 3}, {0, 3}).wall ({0, 3}, {0, 0});
  const FloorPlan plan = room.plan();
  EXPECT_NEAR (sumOfLengths (plan), 14_m, 1_mm);
  EXPECT_EQ (numberOfOpenings (plan), 0u);
}

TEST (FloorPlan, HasADoorUpToTheCornerOfARoom)
{
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  room.wall ({0, 0}, {4, 0}, {{0.0, 0.9, 0.0, 2.05}}).wall ({4, 0}, {4, 3});
  room.wall ({4, 3}, {0, 3}).wall ({0, 3}, {0, 0});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (numberOfOpenings (plan), 1u);
  EXPECT_NEAR (plan.walls.at (0).openings.at (0).width(), 0.9_m, 6_cm);
}

TEST (FloorPlan, DividesTwoRoomsByAWallWithADoorThatWasSeenFromBothSides)
{
  Building flat = twoRooms();
  const FloorPlan plan = flat.plan();
  ASSERT_EQ (plan.rooms.size(), 2u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.01);
  EXPECT_NEAR (plan.rooms[1].area, 12.0, 0.01);
  EXPECT_EQ (numberOfOpenings (plan), 2u) << "one of each side";
  std::size_t thick = 0;
  for (const PlanWall& wall : plan.walls)
    if (wall.thickness) {
      EXPECT_NEAR (*wall.thickness, 10_cm, 1_mm);
      ++thick;
    }
  EXPECT_EQ (thick, 2u);
}

/** \brief Two rooms of 4 m x 3 m beside each other with a wall between them, 20 cm
 * thick. Of this wall 1.2 m were seen, from both sides. */
Building
twoRoomsWithAPieceOfWall ()
{
  Building flat;
  for (const double x : {0.0, 4.2}) {
    flat.level (PlaneKind::Floor, 0.0, {x, 0}, {x + 4, 3});
    flat.wall ({x, 0}, {x + 4, 0}).wall ({x + 4, 3}, {x, 3});
  }
  flat.wall ({8.2, 0}, {8.2, 3}).wall ({0, 3}, {0, 0});
  flat.wall ({4, 0}, {4, 1.2}).wall ({4.2, 1.2}, {4.2, 0});
  return flat;
}

TEST (FloorPlan, DividesTwoRoomsWhoseFloorsEndAtAWallThatWasNotSeen)
{
  const FloorPlan plan = twoRoomsWithAPieceOfWall().plan();
  ASSERT_EQ (plan.rooms.size(), 2u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.01);
  EXPECT_NEAR (plan.rooms[1].area, 12.0, 0.01);
}

TEST (FloorPlan, HasOneRoomWhereTheFloorGoesOnBesideAPieceOfWall)
{
  Building flat = twoRoomsWithAPieceOfWall();
  flat.level (PlaneKind::Floor, 0.0, {4, 1.2}, {4.2, 3});
  const FloorPlan plan = flat.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  // The area includes the inside of the piece of wall: no wall closes its end.
  EXPECT_NEAR (plan.rooms[0].area, 8.2 * 3.0, 0.01);
}

TEST (FloorPlan, IsTheSameWhicheverWayTheNormalsOfWallsPoint)
{
  Building flat = twoRooms();
  const FloorPlan before = flat.plan();
  // As if all planes had been seen from far away, from a position with x and y below 0.
  for (PlaneSegment& plane : flat.planes)
    if (plane.normal.dot (Vector3d (1.0, 0.5, 0.0)) > 0.0)
      plane.normal = -plane.normal;
  const FloorPlan plan = flat.plan();
  ASSERT_EQ (plan.rooms.size(), 2u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.01);
  ASSERT_EQ (plan.walls.size(), before.walls.size());
  for (std::size_t i = 0; i < plan.walls.size(); ++i) {
    EXPECT_TRUE (plan.walls[i].from.isApprox (before.walls[i].from)) << i;
    EXPECT_EQ (plan.walls[i].thickness.has_value(),
               before.walls[i].thickness.has_value());
  }
}

TEST (FloorPlan, IsTheSameInReverseOrderOfPlanes)
{
  Building flat = twoRooms();
  const FloorPlan before = flat.plan();
  std::reverse (flat.planes.begin(), flat.planes.end());
  std::reverse (flat.kinds.begin(), flat.kinds.end());
  const FloorPlan plan = flat.plan();
  EXPECT_EQ (plan.walls.size(), before.walls.size());
  EXPECT_NEAR (sumOfLengths (plan), sumOfLengths (before), 1_mm);
  EXPECT_EQ (numberOfOpenings (plan), numberOfOpenings (before));
  ASSERT_EQ (plan.rooms.size(), 2u);
  EXPECT_NEAR (plan.rooms[1].area, 12.0, 0.01);
}

TEST (FloorPlan, DividesTwoRoomsByAWallThatWasSeenFromOneSide)
{
  Building flat;
  flat.level (PlaneKind::Floor, 0.0, {0, 0}, {8, 3});
  flat.wall ({0, 0}, {8, 0}).wall ({8, 0}, {8, 3}).wall ({8, 3}, {0, 3});
  flat.wall ({0, 3}, {0, 0}).wall ({5, 0}, {5, 3});
  const FloorPlan plan = flat.plan();
  ASSERT_EQ (plan.rooms.size(), 2u);
  EXPECT_NEAR (plan.rooms[0].area, 15.0, 0.01);
  EXPECT_NEAR (plan.rooms[1].area, 9.0, 0.01);
}

TEST (FloorPlan, HasAWallBetweenWallsOfBothNeighborsThatStandBeforeIt)
{
  // Three rooms in a row, of which the middle one reaches 20 cm farther to both sides.
  Building flat;
  const auto addRoom = [&flat] (const Vector2d& low, const Vector2d& high) {
    flat.level (PlaneKind::Floor, 0.0, low, high);
    flat.wall (low, {high.x(), low.y()}).wall ({high.x(), low.y()}, high);
    flat.wall (high, {low.x(), high.y()}).wall ({low.x(), high.y()}, low);
  };
  addRoom ({0.0, 0.0}, {4.0, 3.0});
  addRoom ({4.1, -0.2}, {7.1, 3.2});
  addRoom ({7.2, 0.0}, {11.2, 3.0});
  const FloorPlan plan = flat.plan();
  EXPECT_EQ (plan.walls.size(), 12u);
  EXPECT_EQ (numberOfOpenings (plan), 0u);
  ASSERT_EQ (plan.rooms.size(), 3u);
  EXPECT_NEAR (plan.rooms[2].area, 3.0 * 3.4, 0.01);
}

TEST (FloorPlan, DividesRoomsByTwoWallsOnOneLineThatFaceOppositeWays)
{
  // Three rooms around a corner at (4.1, 3): at the lower left, the lower right and the
  // upper right. The line y = 3 m has the upper wall of the first, which faces down,
  // and the lower wall of the last, which faces up.
  Building flat;
  flat.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  flat.level (PlaneKind::Floor, 0.0, {4.1, 0}, {8.1, 3});
  flat.level (PlaneKind::Floor, 0.0, {4.1, 3}, {8.1, 6});
  flat.wall ({0, 0}, {4, 0}).wall ({4, 0}, {4, 3});
  flat.wall ({4, 3}, {0, 3}).wall ({0, 3}, {0, 0});
  flat.wall ({4.1, 0}, {8.1, 0}).wall ({8.1, 0}, {8.1, 6}).wall ({8.1, 6}, {4.1, 6});
  flat.wall ({4.1, 6}, {4.1, 0}).wall ({4.1, 3}, {8.1, 3});
  const FloorPlan plan = flat.plan();
  ASSERT_EQ (plan.rooms.size(), 3u);
  for (const PlanRoom& room : plan.rooms)
    EXPECT_NEAR (room.area, 12.0, 0.01);
}

TEST (FloorPlan, HasOneRoomThoughLinesOfAThinWallBesideItCrossWhereItsFloorIsUnseen)
{
  // A room of 8 m x 6 m. Right of it a wall of 1 cm divides two rooms of 3 m x 3 m. The
  // lines of both its sides go on through the large room, over 0.4 m of unseen floor.
  Building flat;
  flat.level (PlaneKind::Floor, 0.0, {0, 0}, {8, 2.8});
  flat.level (PlaneKind::Floor, 0.0, {0, 3.2}, {8, 6});
  flat.level (PlaneKind::Floor, 0.0, {8.1, 0}, {11.1, 6});
  flat.wall ({0, 0}, {8, 0}).wall ({8, 0}, {8, 6});
  flat.wall ({8, 6}, {0, 6}).wall ({0, 6}, {0, 0});
  flat.wall ({8.1, 0}, {11.1, 0}).wall ({11.1, 0}, {11.1, 6});
  flat.wall ({11.1, 6}, {8.1, 6}).wall ({8.1, 6}, {8.1, 0});
  flat.wall ({11.1, 3}, {8.1, 3}).wall ({8.1, 3.01}, {11.1, 3.01});
  const FloorPlan plan = flat.plan();
  ASSERT_EQ (plan.rooms.size(), 3u);
  EXPECT_NEAR (plan.rooms[0].area, 48.0, 0.01);
}

TEST (FloorPlan, HasARoomScannedSparselyBesideALargerOneScannedDensely)
{
  // Points are 5 cm apart on floor and ceiling at the left, and 15 cm on the floor at
  // the right.
  Building flat;
  flat.level (PlaneKind::Floor, 0.0, {0, 0}, {8, 3});
  flat.level (PlaneKind::Ceiling, 2.5, {0, 0}, {8, 3});
  flat.wall ({0, 0}, {8, 0}).wall ({8, 0}, {8, 3});
  flat.wall ({8, 3}, {0, 3}).wall ({0, 3}, {0, 0});
  addSparseFloor (flat, {8.1, 0}, {12.1, 3});
  flat.wall ({8.1, 0}, {12.1, 0}).wall ({12.1, 0}, {12.1, 3});
  flat.wall ({12.1, 3}, {8.1, 3}).wall ({8.1, 3}, {8.1, 0});
  const FloorPlan plan = flat.plan();
  ASSERT_EQ (plan.rooms.size(), 2u);
  EXPECT_NEAR (plan.rooms[0].area, 24.0, 0.01);
  EXPECT_NEAR (plan.rooms[1].area, 12.0, 0.01);
}

TEST (FloorPlan, HasOneSparseRoomWhereItsFloorGoesOnBesideAPieceOfWall)
{
  // A room of 8.2 m x 3 m with a piece of wall 0.6 m long and 20 cm thick, beside a
  // room of 8.2 m x 6 m that was scanned densely.
  Building flat;
  addSparseFloor (flat, {0, 0}, {4, 0.6});
  addSparseFloor (flat, {4.2, 0}, {8.2, 0.6});
  addSparseFloor (flat, {0, 0.6}, {8.2, 3});
  flat.wall ({0, 0}, {8.2, 0}).wall ({8.2, 0}, {8.2, 3});
  flat.wall ({8.2, 3}, {0, 3}).wall ({0, 3}, {0, 0});
  flat.wall ({4, 0}, {4, 0.6}).wall ({4.2, 0.6}, {4.2, 0});
  flat.level (PlaneKind::Floor, 0.0, {0, 3.1}, {8.2, 9.1});
  flat.wall ({0, 3.1}, {8.2, 3.1}).wall ({8.2, 3.1}, {8.2, 9.1});
  flat.wall ({8.2, 9.1}, {0, 9.1}).wall ({0, 9.1}, {0, 3.1});
  EXPECT_EQ (flat.plan().rooms.size(), 2u);
}

TEST (FloorPlan, HasARoomUnderARoofOfFewPoints)
{
  // Six points per square meter, as in a survey from the air.
  Building house;
  std::vector<Vector3d> roof;
  for (double x = 0.2; x < 8.0; x += 40_cm)
    for (double y = 0.2; y < 6.0; y += 40_cm)
      roof.emplace_back (x, y, 3.0 + 0.2 * y);
  house.add (PlaneKind::Roof, Vector3d (0.0, -0.2, 1.0).normalized(), roof);
  house.wall ({8, 0}, {0, 0}).wall ({8, 6}, {8, 0});
  house.wall ({0, 6}, {8, 6}).wall ({0, 0}, {0, 6});
  const FloorPlan plan = house.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 48.0, 0.01);
}

TEST (FloorPlan, HasAWholeRoomThoughASlopingPieceInItIsNamedRoof)
{
  // A lamp or a bulkhead is named a roof if no ceiling was seen.
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {8, 6});
  std::vector<Vector3d> piece;
  for (double x = 0.1; x < 1.0; x += 10_cm)
    for (double y = 0.1; y < 1.0; y += 10_cm)
      piece.emplace_back (x, y, 2.2 + 0.3 * y);
  room.add (PlaneKind::Roof, Vector3d (0.0, -0.3, 1.0).normalized(), piece);
  room.wall ({0, 0}, {8, 0}).wall ({8, 0}, {8, 6});
  room.wall ({8, 6}, {0, 6}).wall ({0, 6}, {0, 0});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 48.0, 0.01);
}

TEST (FloorPlan, OfAHouseWithEavesOnItsGroundHasTheRoomUnderTheRoof)
{
  Building house;
  house.level (PlaneKind::Floor, 0.0, {-10, -10}, {18, 16});
  std::vector<Vector3d> roof;
  for (double x = -0.4; x < 8.5; x += 20_cm)
    for (double y = -0.4; y < 6.5; y += 20_cm)
      roof.emplace_back (x, y, 3.0 + 0.2 * y);
  house.add (PlaneKind::Roof, Vector3d (0.0, -0.2, 1.0).normalized(), roof);
  house.wall ({8, 0}, {0, 0}).wall ({8, 6}, {8, 0});
  house.wall ({0, 6}, {8, 6}).wall ({0, 0}, {0, 6});
  const FloorPlan plan = house.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 48.0, 0.01);
}

TEST (FloorPlan, HasARoomUpToAWallThoughTheFloorBeforeItWasNotSeen)
{
  // The last 0.3 m of the floor lie behind high furniture. Of its front 0.7 m was seen,
  // and was named a wall.
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 2.7});
  room.wall ({0, 0}, {4, 0}).wall ({4, 0}, {4, 3});
  room.wall ({4, 3}, {0, 3}).wall ({0, 3}, {0, 0});
  room.wall ({3.7, 2.7}, {3, 2.7});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.3);
}

TEST (FloorPlan, HasNoRoomBetweenTheSidesOfAWallThatWasSeenInPart)
{
  // Of a wall 3 m long and 0.3 m thick, 2 m of one side and seen_length [m] of the
  // other side were seen. All of the area between the sides is left out of the rooms.
  for (const double seen_length : {2.0, 1.4}) {
    Building room;
    room.level (PlaneKind::Floor, 0.0, {0, 0}, {8, 3});
    room.wall ({0, 0}, {8, 0}).wall ({8, 0}, {8, 3});
    room.wall ({8, 3}, {0, 3}).wall ({0, 3}, {0, 0});
    room.wall ({4, 0}, {4, 2}).wall ({4.3, seen_length}, {4.3, 0});
    double area = 0.0;
    for (const PlanRoom& found : room.plan().rooms)
      area += found.area;
    EXPECT_NEAR (area, 24.0 - 0.3 * 3.0, 0.01) << seen_length;
  }
}

TEST (FloorPlan, HasARoomUpToTheEndsOfItsWallsWhereTheLastOneWasNotSeen)
{
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  room.wall ({0, 0}, {4, 0}).wall ({4, 3}, {0, 3}).wall ({0, 3}, {0, 0});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.2);
  ASSERT_EQ (plan.rooms[0].unseen.size(), 1u);
  const auto& [from, to] = plan.rooms[0].unseen[0];
  EXPECT_NEAR ((to - from).norm(), 3_m, 1_cm);
}

TEST (FloorPlan, HasTheSameRoomsWhicheverWayABuildingIsTurned)
{
  // A room without the wall across one of its corners, and one between walls that lean
  // towards each other, without the wall at their far ends.
  Building corner;
  corner.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 5});
  corner.level (PlaneKind::Floor, 0.0, {4, 2}, {6, 5});
  corner.wall ({0, 0}, {4, 0}).wall ({6, 2}, {6, 5});
  corner.wall ({6, 5}, {0, 5}).wall ({0, 5}, {0, 0});
  Building wedge;
  wedge.level (PlaneKind::Floor, 0.0, {0, 0.7}, {4, 2.3});
  wedge.wall ({0, 0}, {4, 0.7}).wall ({4, 2.3}, {0, 3}).wall ({0, 3}, {0, 0});
  for (const Building& building : {corner, wedge}) {
    const FloorPlan plan = building.plan();
    ASSERT_EQ (plan.rooms.size(), 1u);
    for (const double degrees : {20.0, 45.0, 70.0}) {
      const FloorPlan turned = turnedBy (degrees * 1_deg, building).plan();
      ASSERT_EQ (turned.rooms.size(), 1u) << degrees;
      EXPECT_NEAR (turned.rooms[0].area, plan.rooms[0].area, 0.01) << degrees;
    }
  }
}

TEST (FloorPlan, HasAWallThatFurnitureHidesAtTheCutIfTheFloorEndsAtIt)
{
  // Furniture 0.5 m deep hides the wall at x = 4 m up to 1.9 m, and the floor under
  // itself.
  const Opening hidden_by_furniture = {0.0, 3.0, 0.0, 1.9};
  const auto planWithFloorUpTo = [&] (double floor_end) {
    Building room;
    room.level (PlaneKind::Floor, 0.0, {0, 0}, {floor_end, 3});
    room.wall ({0, 0}, {4, 0}).wall ({4, 3}, {0, 3}).wall ({0, 3}, {0, 0});
    return room.wall ({4, 0}, {4, 3}, {hidden_by_furniture}).plan();
  };
  const FloorPlan plan = planWithFloorUpTo (3.5);
  EXPECT_EQ (plan.walls.size(), 4u);
  EXPECT_EQ (numberOfOpenings (plan), 0u);
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.01);
  EXPECT_TRUE (plan.rooms[0].unseen.empty());
  EXPECT_EQ (planWithFloorUpTo (6.0).walls.size(), 3u) << "a lintel: the floor goes on";
}

TEST (FloorPlan, HasNoWallThatBeginsHigherThanFurnitureHides)
{
  Building high;
  high.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  EXPECT_TRUE (high.wall ({0, 3}, {4, 3}, {{0.0, 4.0, 0.0, 2.3}}).plan().walls.empty());
}

TEST (FloorPlan, HasNoWallThatEndsBelowTheCut)
{
  FloorPlanParameters above_wall; // which is 2.5 m high
  above_wall.cut_height = 3_m;
  EXPECT_TRUE (Building().wall ({0, 0}, {4, 0}).plan (above_wall).walls.empty());
}

TEST (FloorPlan, OfAnLHasOneRoomWithSixCorners)
{
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 2})
      .level (PlaneKind::Floor, 0.0, {0, 2}, {2, 4});
  room.wall ({0, 0}, {4, 0}).wall ({4, 0}, {4, 2}).wall ({4, 2}, {2, 2});
  room.wall ({2, 2}, {2, 4}).wall ({2, 4}, {0, 4}).wall ({0, 4}, {0, 0});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.01);
  EXPECT_EQ (plan.rooms[0].rings.at (0).size(), 6u);
  EXPECT_TRUE (plan.rooms[0].middle.isApprox (Vector2d (5.0 / 3.0, 5.0 / 3.0), 1e-3));
}

TEST (FloorPlan, OfARoomAroundAShaftHasAHole)
{
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {6, 2})
      .level (PlaneKind::Floor, 0.0, {0, 4}, {6, 6});
  room.level (PlaneKind::Floor, 0.0, {0, 2}, {2, 4})
      .level (PlaneKind::Floor, 0.0, {4, 2}, {6, 4});
  room.wall ({0, 0}, {6, 0})
      .wall ({6, 0}, {6, 6})
      .wall ({6, 6}, {0, 6})
      .wall ({0, 6}, {0, 0});
  room.wall ({2, 4}, {4, 4})
      .wall ({4, 4}, {4, 2})
      .wall ({4, 2}, {2, 2})
      .wall ({2, 2}, {2, 4});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_EQ (plan.rooms[0].rings.size(), 2u);
  EXPECT_NEAR (plan.rooms[0].area, 32.0, 0.01);
  const Vector2d center_of_shaft (3.0, 3.0);
  const Vector2d from_center = plan.rooms[0].middle - center_of_shaft;
  EXPECT_GT (from_center.cwiseAbs().maxCoeff(), 1.0) << "not in the shaft";
}

TEST (FloorPlan, IsCutOverTheLowestFloorAtAnyHeight)
{
  Building room = roomOf4By3();
  for (pcl::PointXYZ& point : room.cloud)
    point.z += 30.0f;
  for (PlaneSegment& plane : room.planes)
    plane.moveBy (Vector3d (0, 0, 30));
  const FloorPlan plan = room.plan();
  EXPECT_NEAR (plan.floor, 30_m, 1_mm);
  EXPECT_NEAR (plan.height, 31.2_m, 1_mm);
  EXPECT_EQ (numberOfOpenings (plan), 1u);
}

TEST (FloorPlan, IsCutOverTheFootOfItsWallsWhereItsFloorHasNoPoints)
{
  Building room;
  room.wall ({0, 0}, {4, 0});
  for (pcl::PointXYZ& point : room.cloud)
    point.z += 30.0f;
  room.planes.emplace_back(); // without inliers
  room.kinds.push_back (PlaneKind::Floor);
  const FloorPlan plan = room.plan();
  EXPECT_NEAR (plan.height, 30_m + half_spacing + 1.2_m, 1_mm);
  EXPECT_EQ (plan.walls.size(), 1u);
}

TEST (FloorPlan, CutInAnUpperStoryHasTheHeightOfItsFloor)
{
  Building house = roomOf4By3();
  house.level (PlaneKind::Floor, 2.8, {0, 0}, {4, 3});
  FloorPlanParameters upstairs;
  upstairs.cut_height = 4_m; // over the lowest floor
  EXPECT_NEAR (house.plan (upstairs).floor, 2.8_m, 1_mm);
}

/** \brief Adds all planes of a part, raised by a height. */
void
addRaised (Building& house, const Building& part, double height)
{
  for (std::size_t i = 0; i < part.planes.size(); ++i) {
    std::vector<Vector3d> points;
    for (const pcl::index_t index : part.planes[i].inliers) {
      const pcl::PointXYZ& point = part.cloud[index];
      points.emplace_back (point.x, point.y, height + point.z);
    }
    house.add (part.kinds[i], part.planes[i].normal, points);
  }
}

/** \brief Adds walls 2.5 m high around (from, 0) to (to, 3 m). */
void
addWalls (Building& house, double foot, double from, double to)
{
  Building walls;
  walls.wall ({from, 0}, {to, 0}).wall ({to, 0}, {to, 3});
  walls.wall ({to, 3}, {from, 3}).wall ({from, 3}, {from, 0});
  addRaised (house, walls, foot);
}

/** \brief Adds walls 2.5 m high and their floor, from (from, 0) to (to, 3 m). */
void
addRoom (Building& house, double floor, double from, double to)
{
  house.level (PlaneKind::Floor, floor, {from, 0}, {to, 3});
  addWalls (house, floor, from, to);
}

/** \brief Adds a story 2.5 m high from (0, 0) to (width, 3 m): floor, ceiling and the
 * four walls around them. */
void
addStory (Building& house, double floor, double width)
{
  addRoom (house, floor, 0.0, width);
  house.level (PlaneKind::Ceiling, floor + 2.5, {0, 0}, {width, 3});
}

/** \brief Adds one ceiling over two rooms, but not over the wall between them.
 * \param[in] first,second smallest and largest x of each room [m]; y is 0 to 3 m */
void
addCeilingOverBoth (Building& house,
                    double height,
                    const Vector2d& first,
                    const Vector2d& second)
{
  std::vector<Vector3d> points;
  for (const Vector2d& room : {first, second})
    for (double x = room.x() + half_spacing; x < room.y(); x += grid_spacing)
      for (double y = half_spacing; y < 3.0; y += grid_spacing)
        points.emplace_back (x, y, height);
  house.add (PlaneKind::Ceiling, -Vector3d::UnitZ(), points);
}

/** \brief Returns the heights of the ceilings of all rooms, ascending; 0 for a room
 * without one. */
std::vector<double>
ceilingsOf (const FloorPlan& plan)
{
  std::vector<double> heights;
  for (const PlanRoom& room : plan.rooms)
    heights.push_back (room.ceiling.value_or (0.0));
  std::sort (heights.begin(), heights.end());
  return heights;
}

/** \brief Expects two rooms with ceilings at these heights. */
void
expectCeilings (const FloorPlan& plan, double lower, double higher)
{
  const std::vector<double> ceilings = ceilingsOf (plan);
  ASSERT_EQ (ceilings.size(), 2u);
  EXPECT_NEAR (ceilings[0], lower, 1_mm);
  EXPECT_NEAR (ceilings[1], higher, 1_mm);
}

TEST (FloorPlan, OfAStoryHasItsOwnWallsAndCeilingWhereAnotherStoryIsLarger)
{
  // The cut, over the lowest floor, is in the story that is 4 m long.
  const auto expectStoryOf4Meters = [] (const Building& house, double cut_height) {
    FloorPlanParameters parameters;
    parameters.cut_height = cut_height;
    const FloorPlan plan = house.plan (parameters);
    EXPECT_EQ (plan.walls.size(), 4u) << cut_height;
    EXPECT_NEAR (sumOfLengths (plan), 14_m, 1_cm) << cut_height;
    ASSERT_EQ (plan.rooms.size(), 1u) << cut_height;
    EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.01) << cut_height;
    EXPECT_NEAR (plan.rooms[0].ceiling.value() - plan.floor, 2.5_m, 1_cm) << cut_height;
  };
  Building larger_above;
  addStory (larger_above, 0.0, 4_m);
  addStory (larger_above, 2.8, 8_m);
  expectStoryOf4Meters (larger_above, 1.2);
  Building noisy_above; // its walls begin 2 cm below their floor
  addStory (noisy_above, 0.0, 4_m);
  noisy_above.level (PlaneKind::Floor, 2.8, {0, 0}, {8, 3});
  addWalls (noisy_above, 2.78 - half_spacing, 0.0, 8_m);
  expectStoryOf4Meters (noisy_above, 1.2);
  Building larger_below;
  addStory (larger_below, 0.0, 8_m);
  addStory (larger_below, 2.8, 4_m);
  expectStoryOf4Meters (larger_below, 4.0);
}

TEST (FloorPlan, HasAWallOverWhichOnlyTheCeilingOfTheStoryAboveGoesOn)
{
  Building house;
  addStory (house, 0.0, 8_m);
  addStory (house, 2.8, 8_m);
  house.wall ({4, 0}, {4, 3}).wall ({4.1, 3}, {4.1, 0});
  const FloorPlan plan = house.plan();
  EXPECT_EQ (plan.walls.size(), 6u);
  EXPECT_EQ (plan.rooms.size(), 2u);
}

TEST (FloorPlan, HasAWallOverWhichTheFloorOfTheStoryAboveIsHidden)
{
  Building house;
  addStory (house, 0.0, 8_m);
  house.level (PlaneKind::Floor, 2.8, {0, 0}, {2.7, 3});
  house.level (PlaneKind::Floor, 2.8, {5.4, 0}, {8, 3});
  house.level (PlaneKind::Ceiling, 5.3, {0, 0}, {8, 3});
  house.wall ({4, 0}, {4, 3}).wall ({4.1, 3}, {4.1, 0});
  const FloorPlan plan = house.plan();
  EXPECT_EQ (plan.walls.size(), 6u);
  EXPECT_EQ (plan.rooms.size(), 2u);
}

TEST (FloorPlan, HasTheCeilingOfAHallBesideTwoStories)
{
  // The hall, from x = 0 to 4 m, is as high as the two stories right of it, which have
  // the same ceiling. Its smaller or its larger part is over the hall.
  for (const double end : {6.1, 8.1, 14.1}) {
    Building house;
    addRoom (house, 0.0, 0.0, 4_m);
    addRoom (house, 0.0, 4.1_m, end);
    house.level (PlaneKind::Ceiling, 2.5, {4.1, 0}, {end, 3});
    house.level (PlaneKind::Floor, 2.8, {4.1, 0}, {end, 3});
    addCeilingOverBoth (house, 5.3, {0, 4}, {4.1, end});
    SCOPED_TRACE (end);
    expectCeilings (house.plan(), 2.5, 5.3);
  }
}

TEST (FloorPlan, HasTheCeilingOfAHallOfTwoStoriesInAHouseOfThree)
{
  Building house;
  addRoom (house, 0.0, 0.0, 4_m);
  addRoom (house, 0.0, 4.1_m, 8.1_m);
  house.level (PlaneKind::Ceiling, 2.5, {4.1, 0}, {8.1, 3});
  house.level (PlaneKind::Floor, 2.8, {4.1, 0}, {8.1, 3});
  addCeilingOverBoth (house, 5.3, {0, 4}, {4.1, 8.1});
  house.level (PlaneKind::Floor, 5.6, {0, 0}, {8.1, 3});
  house.level (PlaneKind::Ceiling, 7.1, {0, 0}, {8.1, 3});
  expectCeilings (house.plan(), 2.5, 5.3);
}

TEST (FloorPlan, HasTheCeilingOfAStoryThatIsHigherThanTheOneBesideIt)
{
  Building house;
  addRoom (house, 0.0, 0.0, 4_m);
  addRoom (house, 0.0, 4.1_m, 8.1_m);
  house.level (PlaneKind::Ceiling, 2.5, {0, 0}, {4, 3});
  house.level (PlaneKind::Floor, 2.8, {0, 0}, {4, 3});
  house.level (PlaneKind::Ceiling, 3.5, {4.1, 0}, {8.1, 3});
  house.level (PlaneKind::Floor, 3.8, {4.1, 0}, {8.1, 3});
  expectCeilings (house.plan(), 2.5, 3.5);
}

TEST (FloorPlan, HasAStairwellWithoutAFloorBesideTwoStories)
{
  Building house;
  addRoom (house, 0.0, 0.0, 4_m);
  house.level (PlaneKind::Ceiling, 2.5, {0, 0}, {4, 3});
  addRoom (house, 2.8, 0.0, 4_m);
  for (const double foot : {0.0, 2.5})
    addWalls (house, foot, 4.15_m, 6.65_m);
  addCeilingOverBoth (house, 5.3, {0, 4}, {4.15, 6.65});
  const FloorPlan plan = house.plan();
  ASSERT_EQ (plan.rooms.size(), 2u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.1);
  EXPECT_NEAR (plan.rooms[1].area, 7.5, 0.1);
  EXPECT_NEAR (plan.rooms[1].ceiling.value_or (0.0), 5.3, 1_mm);
  EXPECT_TRUE (
      std::any_of (plan.walls.begin(), plan.walls.end(), [] (const PlanWall& wall) {
        return std::abs (wall.from.x() - 4_m) < 1_cm &&
               std::abs (wall.to.x() - 4_m) < 1_cm;
      }));
}

/** \brief Adds a hall's floor, from (0, 0) to (4, 3 m), and a wall of it, 5.3 m high,
 * with a gate of 1.5 m x 3.5 m. */
void
addHallWithGate (Building& house)
{
  house.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  std::vector<Vector3d> wall = uprightAlongX (0.0, {0.025, 3.5}, {4.0, 5.3});
  for (const Vector2d& beside_gate : {Vector2d (0.025, 1.0), Vector2d (2.525, 4.0)}) {
    const std::vector<Vector3d> part =
        uprightAlongX (0.0, {beside_gate.x(), 0.025}, {beside_gate.y(), 3.5});
    wall.insert (wall.end(), part.begin(), part.end());
  }
  house.add (PlaneKind::Wall, Vector3d::UnitY(), wall);
}

/** \brief Expects one opening, with its head at this height. */
void
expectHead (const FloorPlan& plan, double head)
{
  EXPECT_EQ (numberOfOpenings (plan), 1u);
  for (const PlanWall& wall : plan.walls)
    for (const PlanOpening& opening : wall.openings)
      EXPECT_NEAR (opening.head.value_or (0.0), head, 6_cm);
}

TEST (FloorPlan, HasTheHeadOfTheGateOfAHallBesideTwoStories)
{
  Building house;
  addHallWithGate (house);
  addRoom (house, 0.0, 4.1_m, 8.1_m);
  house.level (PlaneKind::Ceiling, 2.5, {4.1, 0}, {8.1, 3});
  addRoom (house, 2.8, 4.1_m, 8.1_m);
  expectHead (house.plan(), 3.5);
}

TEST (FloorPlan, HasTheHeadOfAGateThoughTheGroundIsHigherElsewhere)
{
  Building house;
  addHallWithGate (house);
  house.level (PlaneKind::Floor, 2.5, {10, 0}, {14, 3}); // on a hill
  expectHead (house.plan(), 3.5);
}

TEST (FloorPlan, OfAGroundFloorEndsAtItsWallsThoughASmallBasementReachesBeyond)
{
  Building house;
  addStory (house, 0.0, 8_m);
  addRoom (house, -2.8, 7_m, 8.5_m); // a fifth of the ground floor would be 1.6 m
  house.level (PlaneKind::Ceiling, -0.3, {7, 0}, {8.5, 3});
  const FloorPlan plan = house.plan();
  EXPECT_EQ (plan.walls.size(), 4u);
  EXPECT_NEAR (sumOfLengths (plan), 22_m, 1_cm);
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 24.0, 0.01);
}

TEST (FloorPlan, HasTheFloorOfItsStoryAndNotThatOfALanding)
{
  Building room;
  addStory (room, 0.0, 4_m);
  room.level (PlaneKind::Floor, 0.9, {0, 0}, {1, 1});
  EXPECT_NEAR (room.plan().floor, 0.0, 1_mm);
}

TEST (FloorPlan, HasSillsOfWindowsBelowTheHigherFloorOfASplitLevel)
{
  Building house;
  house.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  house.level (PlaneKind::Floor, 1.0, {4.1, 0}, {8.1, 3});
  constexpr double sill = 0.5;
  house.wall ({0, 0}, {4, 0}, {{1.0, 2.5, sill, 2.1}});
  const FloorPlan plan = house.plan();
  ASSERT_EQ (numberOfOpenings (plan), 1u);
  const PlanOpening& found_window = plan.walls.at (0).openings.at (0);
  EXPECT_NEAR (plan.floor + found_window.sill.value_or (9.0), sill, 6_cm);
}

TEST (FloorPlan, HasNoRoomUnderARoofIfOnlyTheCeilingOfTheStoryAboveWasSeen)
{
  // Beside the room, from x = 4 m to 8 m, a roof covers what has no floor.
  Building house;
  addRoom (house, 0.0, 0.0, 4_m);
  house.wall ({4, 0}, {8, 0}).wall ({8, 0}, {8, 3}).wall ({8, 3}, {4, 3});
  addStory (house, 2.8, 4_m);
  house.level (PlaneKind::Roof, 6.0, {0, 0}, {8, 3});
  const FloorPlan plan = house.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.1);
}

TEST (FloorPlan, HasARoomOverATableASlabOrARampInsteadOfAFloor)
{
  const auto roomsOver = [] (PlaneKind kind) {
    Building room;
    room.level (kind, 0.5, {0, 0}, {4, 3});
    room.wall ({0, 0}, {4, 0}).wall ({4, 0}, {4, 3});
    room.wall ({4, 3}, {0, 3}).wall ({0, 3}, {0, 0});
    return room.plan().rooms.size();
  };
  for (const PlaneKind kind : {PlaneKind::Table, PlaneKind::Slab, PlaneKind::Ramp})
    EXPECT_EQ (roomsOver (kind), 1u) << toString (kind);
  EXPECT_EQ (roomsOver (PlaneKind::Other), 0u);
}

TEST (FloorPlan, HasARoomWhoseFloorIsHiddenInTheMiddle)
{
  Building room;
  for (const double y : {0.0, 2.0})
    room.level (PlaneKind::Floor, 0.0, {0, y}, {4, y + 1});
  for (const double x : {0.0, 3.0})
    room.level (PlaneKind::Floor, 0.0, {x, 1}, {x + 1, 2});
  room.wall ({0, 0}, {4, 0}).wall ({4, 0}, {4, 3});
  room.wall ({4, 3}, {0, 3}).wall ({0, 3}, {0, 0});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 12.0, 0.01);
}

TEST (FloorPlan, HasATriangularRoomMostOfWhichIsCovered)
{
  // The seen floor is three quarters of the triangle, but less than half of the
  // rectangle around the triangle.
  std::vector<Vector3d> floor;
  for (double x = 0.025; x < 2.0; x += 5_cm)
    for (double y = 0.025; x + y < 4.0; y += 5_cm)
      floor.emplace_back (x, y, 0.0);
  Building room;
  room.add (PlaneKind::Floor, Vector3d::UnitZ(), floor);
  room.wall ({0, 0}, {4, 0}).wall ({4, 0}, {0, 4}).wall ({0, 4}, {0, 0});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, 8.0, 0.01);
}

TEST (FloorPlan, HasTheFloorOfEachRoomWhereOneLiesInTheCornerOfAnother)
{
  // An L of 9 m^2 around a room of 16 m^2 whose floor is 20 cm lower.
  Building flat;
  flat.level (PlaneKind::Floor, 0.0, {0, 0}, {5, 1});
  flat.level (PlaneKind::Floor, 0.0, {0, 1}, {1, 5});
  flat.level (PlaneKind::Floor, -0.2, {1, 1}, {5, 5});
  flat.wall ({0, 0}, {5, 0}).wall ({5, 0}, {5, 5});
  flat.wall ({5, 5}, {0, 5}).wall ({0, 5}, {0, 0});
  flat.wall ({1, 5}, {1, 1}).wall ({1, 1}, {5, 1});
  const FloorPlan plan = flat.plan();
  ASSERT_EQ (plan.rooms.size(), 2u);
  EXPECT_NEAR (plan.rooms[0].area, 16.0, 0.01);
  EXPECT_NEAR (plan.rooms[0].floor.value_or (9.0), -0.2, 1_mm);
  EXPECT_NEAR (plan.rooms[1].area, 9.0, 0.01);
  EXPECT_NEAR (plan.rooms[1].floor.value_or (9.0), 0.0, 1_mm);
}

TEST (FloorPlan, OfSparsePointsHasAWallWithoutOpenings)
{
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  std::vector<Vector3d> wall; // points 40 cm apart
  for (double x = 0.0; x <= 4.0; x += 40_cm)
    for (double z = 0.0; z < 2.5; z += 40_cm)
      wall.emplace_back (x, 0.0, z);
  room.add (PlaneKind::Wall, Vector3d::UnitY(), wall);
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.walls.size(), 1u);
  EXPECT_NEAR (plan.walls[0].length(), 4_m, 1_mm);
  EXPECT_EQ (numberOfOpenings (plan), 0u);
}

TEST (FloorPlan, HasBothSidesOfAThinWall)
{
  Building flat;
  flat.level (PlaneKind::Floor, 0.0, {0, 0}, {8, 3});
  flat.wall ({4, 0}, {4, 3}).wall ({4.03, 3}, {4.03, 0});
  const FloorPlan plan = flat.plan();
  ASSERT_EQ (plan.walls.size(), 2u);
  for (const PlanWall& wall : plan.walls)
    EXPECT_NEAR (wall.thickness.value_or (0.0), 3_cm, 1_mm);
}

TEST (FloorPlan, IsTheSameInUtmCoordinatesAndForAnotherUpAxis)
{
  const Building building = roomOf4By3();
  const Vector3d shift (500'000, 5'400'000, 100);
  std::vector<PlaneSegment> moved = building.planes;
  for (PlaneSegment& plane : moved)
    plane.moveBy (shift);
  const FloorPlan in_utm = findFloorPlan (
      building.cloud, moved, building.kinds, Vector3d::UnitZ(), {}, shift);
  EXPECT_NEAR (in_utm.rooms.at (0).area, 12.0, 0.01);
  EXPECT_NEAR (in_utm.rooms.at (0).floor.value(), 100.0, 1_mm);
  EXPECT_NEAR (in_utm.walls.at (1).from.x(), 500'004.0, 1_mm);
  EXPECT_EQ (in_utm.walls.at (0).openings.at (0).room_before, std::size_t (0));

  Building turned = building; // y down, z ahead, as cameras have it
  for (pcl::PointXYZ& point : turned.cloud)
    point = toPoint ({point.x, -point.z, point.y});
  for (PlaneSegment& plane : turned.planes)
    plane.normal = {plane.normal.x(), -plane.normal.z(), plane.normal.y()};
  const FloorPlan in_camera =
      findFloorPlan (turned.cloud, turned.planes, turned.kinds, -Vector3d::UnitY());
  EXPECT_NEAR (in_camera.rooms.at (0).area, 12.0, 0.01);
  EXPECT_EQ (numberOfOpenings (in_camera), 1u);
}

TEST (FloorPlan, OfACloudInMillimetersIsInMeters)
{
  Building building = roomOf4By3();
  for (pcl::PointXYZ& point : building.cloud)
    point.getVector3fMap() *= 1000.0f;
  FloorPlanParameters millimeters;
  millimeters.meter = 1000.0;
  const Vector3d shift (7000.0, 0.0, 500.0); // [mm]
  const FloorPlan plan = findFloorPlan (building.cloud,
                                        building.planes,
                                        building.kinds,
                                        Vector3d::UnitZ(),
                                        millimeters,
                                        shift);
  const FloorPlan expected = roomOf4By3().plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  EXPECT_NEAR (plan.rooms[0].area, expected.rooms.at (0).area, 1e-4);
  EXPECT_NEAR (plan.rooms[0].middle.x(), expected.rooms[0].middle.x() + 7_m, 1e-4);
  EXPECT_NEAR (plan.rooms[0].floor.value(), 0.5, 1e-4) << "500 mm";
  EXPECT_EQ (numberOfOpenings (plan), numberOfOpenings (expected));
}

TEST (FloorPlan, OfNothingIsEmpty)
{
  const FloorPlan plan = Building().plan();
  EXPECT_TRUE (plan.walls.empty());
  EXPECT_TRUE (plan.rooms.empty());
}

TEST (FloorPlan, RefusesInvalidParametersAndPlanesOfAnotherCloud)
{
  const Building building = roomOf4By3();
  FloorPlanParameters wrong;
  wrong.min_opening = -1.0;
  EXPECT_THROW (building.plan (wrong), std::invalid_argument);
  wrong = {};
  wrong.meter = 1e-320;
  EXPECT_THROW (building.plan (wrong), std::invalid_argument);
  const Vector3d up = Vector3d::UnitZ();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW (findFloorPlan (building.cloud,
                               building.planes,
                               building.kinds,
                               up,
                               {},
                               Vector3d (nan, 0.0, 0.0)),
                std::invalid_argument);
  EXPECT_THROW (findFloorPlan (building.cloud, building.planes, {}, up),
                std::invalid_argument);
  EXPECT_THROW (
      findFloorPlan (building.cloud, building.planes, building.kinds, {0, 0, 0}),
      std::invalid_argument);
  EXPECT_THROW (findFloorPlan (Building().cloud, building.planes, building.kinds, up),
                std::invalid_argument);
}

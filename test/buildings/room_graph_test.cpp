// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "building.h"
#include "buildings/room_graph.h"

namespace {

/** \brief Indices into FloorPlan::rooms. */
using Rooms = std::vector<std::size_t>;

/** \brief The openings of all walls, wall after wall. */
std::vector<PlanOpening>
allOpenings (const FloorPlan& plan)
{
  std::vector<PlanOpening> all;
  for (const PlanWall& wall : plan.walls)
    all.insert (all.end(), wall.openings.begin(), wall.openings.end());
  return all;
}

} // namespace

TEST (RoomGraph, HasTheRoomsBeforeAndBehindADoorOnBothSidesOfItsWall)
{
  const FloorPlan plan = twoRooms().plan();
  const std::vector<PlanOpening> doors = allOpenings (plan);
  ASSERT_EQ (doors.size(), 2u);
  for (const PlanOpening& opening : doors) {
    EXPECT_TRUE (opening.isDoor());
    const bool is_on_left_side = opening.from.x() < 4.05; // the middle of the wall
    const bool is_left_room_before =
        plan.rooms.at (opening.room_before.value()).middle.x() < 4.0;
    EXPECT_EQ (is_left_room_before, is_on_left_side);
    EXPECT_NE (opening.room_before, opening.room_behind);
    EXPECT_TRUE (opening.room_behind);
  }
  EXPECT_EQ (plan.roomsBehindDoorsOf (0), Rooms{1});
  EXPECT_EQ (plan.roomsBehindDoorsOf (1), Rooms{0});
}

TEST (RoomGraph, HasTheRoomBehindAWallOfWhichOneSideWasSeen)
{
  // Two rooms with a wall of 30 cm between them, seen from the left room alone.
  Building flat;
  for (const double x : {0.0, 4.3}) {
    flat.level (PlaneKind::Floor, 0.0, {x, 0}, {x + 4, 3});
    flat.wall ({x, 0}, {x + 4, 0}).wall ({x + 4, 3}, {x, 3});
  }
  flat.wall ({8.3, 0}, {8.3, 3}).wall ({0, 3}, {0, 0}).wall ({4, 0}, {4, 3}, {door});
  const FloorPlan plan = flat.plan();
  ASSERT_EQ (plan.rooms.size(), 2u);
  EXPECT_EQ (plan.roomsBehindDoorsOf (0), Rooms{1});
}

TEST (RoomGraph, HasNoWayThroughAWindow)
{
  const Opening with_high_sill = {1.0, 1.9, 0.9, 2.0};
  const FloorPlan plan = twoRooms (with_high_sill).plan();
  const std::vector<PlanOpening> windows = allOpenings (plan);
  ASSERT_EQ (windows.size(), 2u);
  for (const PlanOpening& opening : windows) {
    EXPECT_FALSE (opening.isDoor());
    EXPECT_TRUE (opening.room_before && opening.room_behind)
        << "a window between rooms";
  }
  EXPECT_EQ (plan.roomsBehindDoorsOf (0), Rooms());
}

TEST (RoomGraph, HasAWayOverASillAsLowAsAThreshold)
{
  const auto roomsBehind = [] (double sill) {
    const Opening opening = {1.0, 1.9, sill, 2.0};
    return twoRooms (opening).plan().roomsBehindDoorsOf (0);
  };
  EXPECT_EQ (roomsBehind (0.2), Rooms{1});
  EXPECT_EQ (roomsBehind (0.3), Rooms());
}

TEST (RoomGraph, HasNoRoomBehindADoorThatLeadsOut)
{
  const FloorPlan plan = roomOf4By3().plan();
  const PlanOpening way_out = allOpenings (plan).at (0);
  EXPECT_EQ (way_out.room_before, std::size_t (0));
  EXPECT_FALSE (way_out.room_behind);
  EXPECT_EQ (plan.roomsBehindDoorsOf (0), Rooms());
}

TEST (IsInRoom, IsFalseInAShaftAndOutside)
{
  PlanRoom around; // a shaft of 2 m x 2 m
  around.rings = {{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{2, 2}, {2, 4}, {4, 4}, {4, 2}}};
  using pcl_ops::internal::buildings::isInRoom;
  EXPECT_TRUE (isInRoom (around, {1, 1}));
  EXPECT_FALSE (isInRoom (around, {3, 3})) << "in the shaft";
  EXPECT_FALSE (isInRoom (around, {7, 3})) << "outside";
}

TEST (UnseenPartsOfRooms, AreNoneOfARoomWithFourWallsAndADoor)
{
  EXPECT_TRUE (roomOf4By3().plan().rooms.at (0).unseen.empty());
}

TEST (UnseenPartsOfRooms, AreThoseOfTheOutlineWithoutAWall)
{
  Building room; // of the wall at x = 4 m only the first meter was seen
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  room.wall ({0, 0}, {4, 0}).wall ({4, 0}, {4, 1}).wall ({4, 3}, {0, 3});
  room.wall ({0, 3}, {0, 0});
  const FloorPlan plan = room.plan();
  ASSERT_EQ (plan.rooms.size(), 1u);
  ASSERT_EQ (plan.rooms[0].unseen.size(), 1u);
  const auto& [from, to] = plan.rooms[0].unseen[0];
  EXPECT_TRUE (from.isApprox (Vector2d (4.0, 1.0), 0.01)) << from.transpose();
  EXPECT_TRUE (to.isApprox (Vector2d (4.0, 3.0), 0.01)) << to.transpose();
  EXPECT_NEAR (plan.rooms[0].enclosed, 12.0 / 14.0, 0.01) << "all but 2 m of 14 m";
}

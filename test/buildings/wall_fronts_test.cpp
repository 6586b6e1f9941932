// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "buildings/wall_fronts.h"
#include "scene.h"

using namespace pcl_ops::internal::buildings;

namespace {

/** \brief Adds a floor along the x axis, 1 m deep.
 * \param[in] side 1: where y is above 0; -1: where y is below 0
 * \param[in] length along the x axis [m] */
void
addFloor (double side, double length, PlanPoints& points)
{
  for (double x = 0.025; x < length; x += 5_cm)
    for (double y = 0.025; y < 1.0; y += 5_cm)
      points.emplace_back (x, side * y, 0.0);
}

/** \brief Whether RoomSides finds floors behind a wall, and less than half as much
 * before it. The wall goes 4 m along the x axis and has its front towards +y.
 * \param[in] before,behind lengths of the floors on both sides of the wall [m] */
bool
isFloorMainlyBehind (double before, double behind)
{
  PlanPoints floors;
  addFloor (1.0, before, floors);
  addFloor (-1.0, behind, floors);
  PlanPoints wall;
  for (double x = 0.025; x < 4.0; x += 5_cm)
    for (double z = 0.025; z < 2.5; z += 5_cm)
      wall.emplace_back (x, 0.0, z);
  return RoomSides ({&floors}).areBehind ({0.0, 1.0}, wall);
}

/** \brief Whether a ceiling at 2.5 m goes on from one side to the other above a front
 * of this height [m], which stands along 4 m of the x axis.
 * \param[in] sides on which there is a ceiling, as in \ref addFloor */
bool
goesOnOver (double height, const std::vector<double>& sides)
{
  PlanPoints ceiling;
  for (const double side : sides)
    addFloor (side, 4_m, ceiling);
  for (Eigen::Vector3d& point : ceiling)
    point.z() = 2.5_m;
  PlanPoints front;
  for (double x = 0.025; x < 4.0; x += 5_cm)
    for (double z = 0.025; z < height; z += 5_cm)
      front.emplace_back (x, 0.0, z);
  return RoomSides ({&ceiling}).goOnOver ({0.0, 1.0}, front);
}

} // namespace

TEST (WallFronts, OfFurnitureHaveACeilingThatGoesOnOverThem)
{
  EXPECT_TRUE (goesOnOver (2_m, {1.0, -1.0})) << "a cupboard";
  EXPECT_FALSE (goesOnOver (2.4_m, {1.0, -1.0})) << "up to the ceiling";
  EXPECT_FALSE (goesOnOver (2_m, {1.0})) << "the ceiling ends at it";
  EXPECT_FALSE (goesOnOver (2_m, {})) << "no ceiling was seen";
}

TEST (WallFronts, AreTurnedWhereFloorsAreBehindTheWallAlone)
{
  EXPECT_TRUE (isFloorMainlyBehind (0.0, 4_m));
  EXPECT_FALSE (isFloorMainlyBehind (4_m, 0.0));
  EXPECT_FALSE (isFloorMainlyBehind (0.0, 0.0));
}

TEST (WallFronts, StayWhereFloorsAreOnBothSides)
{
  // Before the wall, furniture hides one of the four meters.
  EXPECT_FALSE (isFloorMainlyBehind (3_m, 4_m));
}

TEST (WallFronts, StayWhereHardlyAnyFloorIsSeen)
{
  EXPECT_FALSE (isFloorMainlyBehind (0.0, 15_cm)) << "three squares of 5 cm";
  EXPECT_TRUE (isFloorMainlyBehind (0.0, 25_cm)) << "five squares of 5 cm";
}

TEST (WallFronts, OfAThinWallAreThoseOfItsOwnRoom)
{
  // A side of a wall, 10 cm thick, is at y, and its other side at y + 10 cm. Floors
  // begin at both sides. The result does not depend on where y is in a grid of 5 cm.
  for (double y = 0.0; y < 5_cm; y += 1_cm) {
    PlanPoints floors;
    PlanPoints wall;
    for (double x = 0.02; x < 4.0; x += 4_cm) {
      for (double from_wall = 0.0; from_wall < 1.0; from_wall += 4_cm) {
        floors.emplace_back (x, y - from_wall, 0.0);
        floors.emplace_back (x, y + 10_cm + from_wall, 0.0);
      }
      for (double z = 0.02; z < 2.5; z += 4_cm)
        wall.emplace_back (x, y, z);
    }
    EXPECT_TRUE (RoomSides ({&floors}).areBehind ({0.0, 1.0}, wall)) << y;
    EXPECT_FALSE (RoomSides ({&floors}).areBehind ({0.0, -1.0}, wall)) << y;
  }
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rectangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

using Eigen::Vector3d;
using namespace pcl_ops;

namespace {

using Names = std::vector<std::string>;

/** \brief Position of a sensor far above: all normals point up, as in a survey. */
const Vector3d far_above (0.0, 0.0, 1e3);

// Rectangles::level takes a height, width and depth along x and y, and x and y of the
// corner of least x and y, by default zero.

} // namespace

TEST (PlaneKinds, OfARoomAreFloorCeilingAndWalls)
{
  EXPECT_EQ (shell().kinds(),
             (Names{"floor", "ceiling", "wall", "wall", "wall", "wall"}));
}

TEST (PlaneKinds, AreTheSameInFeetAndForATiltedUpAxis)
{
  Rectangles room = shell();
  const Eigen::Quaterniond turn (
      Eigen::AngleAxisd (1.0, Vector3d (1, 2, 3).normalized()));
  constexpr double feet_per_meter = 1.0 / 0.3048;
  for (PlaneSegment& plane : room.planes) {
    plane.centroid = feet_per_meter * (turn * plane.centroid);
    plane.normal = turn * plane.normal;
  }
  for (PlaneExtent& extent : room.extents) {
    for (Vector3d& corner : extent.hull)
      corner = feet_per_meter * (turn * corner);
    extent.center = feet_per_meter * (turn * extent.center);
    extent.long_axis = turn * extent.long_axis;
    extent.short_axis = turn * extent.short_axis;
    extent.length *= feet_per_meter;
    extent.width *= feet_per_meter;
    extent.area *= feet_per_meter * feet_per_meter;
  }
  EXPECT_EQ (
      planeKinds (room.planes, room.extents, turn * Vector3d (0, 0, 5), feet_per_meter),
      planeKinds (shell().planes, shell().extents, Vector3d::UnitZ()));
}

TEST (PlaneKinds, AreTheSameInReverseOrderOfPlanes)
{
  Rectangles room = shell(); // with a table, the front of a cupboard, a part of a wall
  room.level (0.72, 1.4, 0.8, 1.0, 1.0).add ({1, 0.4, 0}, {1.2, 0, 0}, {0, 0, 1.8});
  room.add ({4.02, 1, 0.4}, {0, 0.3, 0}, {0, 0, 0.3});
  Rectangles house; // a ground, a wall, a flat roof and a sloping one
  house.sensor = far_above;
  house.level (0.0, 60_m, 40_m, -20.0, -20.0).add ({0, 0, 0}, {10, 0, 0}, {0, 0, 5});
  house.level (5.0, 6_m, 6_m, 20.0, 0.0).add ({0, 0, 5}, {10, 0, 0}, {0, 4, 3});
  Rectangles cellar = shell();
  cellar.add ({1, 1, -1}, {0.2, 0, 0}, {0, 0, 0.2}); // a small plane below the floor
  for (Rectangles scene : {room, house, cellar}) {
    Names expected = scene.kinds();
    ASSERT_EQ (expected.size(), scene.planes.size());
    EXPECT_GT (std::count (expected.begin(), expected.end(), "wall"), 0);
    std::reverse (expected.begin(), expected.end());
    std::reverse (scene.planes.begin(), scene.planes.end());
    std::reverse (scene.extents.begin(), scene.extents.end());
    EXPECT_EQ (scene.kinds(), expected);
  }
}

TEST (PlaneKinds, OfSlopesToBothSidesOfASensorDoNotDependOnTheirOrder)
{
  // Two slopes of 8.5 degrees that rise to both sides of the sensor. It is not known
  // which way the sensor leans.
  const auto kindsOf = [] (double first_side) {
    Rectangles valley;
    valley.sensor = {0, 0, 2};
    for (const double side : {first_side, -first_side})
      valley.add ({0, -5, 0}, {10 * side, 0, 1.5}, {0, 10, 0});
    return valley.kindsFromSensor();
  };
  const Names kinds = kindsOf (1.0);
  EXPECT_EQ (kindsOf (-1.0), (Names{kinds[1], kinds[0]}));
}

TEST (PlaneKinds, OfATopAtTheHeightOfTablesIsATable)
{
  EXPECT_EQ (shell().level (0.72, 1.4, 0.8, 1.0, 1.0).lastKind(), "table");
  EXPECT_EQ (shell().level (0.45, 0.4, 0.4, 1.0, 1.0).lastKind(), "table") << "a seat";
  EXPECT_EQ (shell().level (0.15, 0.8, 0.8, 1.0, 1.0).lastKind(), "other") << "too low";
  EXPECT_EQ (shell().level (1.6, 1.4, 0.8, 1.0, 1.0).lastKind(), "other") << "a shelf";
}

TEST (PlaneKinds, OfTheFrontOfACupboardIsNoWall)
{
  Rectangles room = shell();
  room.add ({1, 0.4, 0}, {1.2, 0, 0}, {0, 0, 1.8});
  EXPECT_EQ (room.lastKind(), "other") << "0.4 m before a wall";
  Rectangles built_in = shell();
  built_in.add ({1, 0.4, 0}, {1.2, 0, 0}, {0, 0, 2.5});
  EXPECT_EQ (built_in.lastKind(), "wall") << "it reaches the ceiling";
}

TEST (PlaneKinds, OfAWallBesideTheEndOfALargerOneIsAWall)
{
  // The kind of a lower wall, 40 cm nearer to the room than the larger one, which goes
  // from x = 0 to 4 m.
  const auto kindAt = [] (double x) {
    Rectangles room;
    room.level (0.0, 8_m, 3_m).add ({0, 3, 0}, {4, 0, 0}, {0, 0, 2.4});
    room.add ({x, 2.6, 0}, {2, 0, 0}, {0, 0, 1.8});
    return room.lastKind();
  };
  EXPECT_EQ (kindAt (5_m), "wall") << "beside it";
  EXPECT_EQ (kindAt (1_m), "other") << "before it";
}

TEST (PlaneKinds, OfALevelAboveAStoryIsARoofWhereNoWallRisesFromIt)
{
  Rectangles house;
  house.sensor = far_above;
  house.level (2.8, 6_m, 5_m).level (0.0, 6_m, 5_m).level (2.5, 6_m, 5_m);
  house.add ({0, 0, 0}, {6, 0, 0}, {0, 0, 2.5});
  EXPECT_EQ (house.kinds().front(), "roof");
  house.add ({0, 0, 2.8}, {6, 0, 0}, {0, 0, 2.5});
  EXPECT_EQ (house.kinds().front(), "floor");
}

TEST (PlaneKinds, OfANarrowOrALowBoardIsNoWall)
{
  EXPECT_EQ (shell().add ({1, 1, 0}, {0, 0.4, 0}, {0, 0, 1.8}).lastKind(), "other")
      << "0.4 m wide";
  EXPECT_EQ (shell().add ({1, 1, 0}, {0, 1.4, 0}, {0, 0, 0.9}).lastKind(), "other")
      << "0.9 m high";
}

TEST (PlaneKinds, OfARoomWhoseCeilingIsOutOfSightAreFloorAndWalls)
{
  Rectangles image; // in which the wall ends 2 m above the floor
  image.level (0.0, 4_m, 3_m).add ({0, 3, 0.1}, {4, 0, 0}, {0, 0, 1.9});
  EXPECT_EQ (image.kinds(), (Names{"floor", "wall"}));
}

TEST (PlaneKinds, OfASmallPartOfAWallIsThatOfTheWall)
{
  // A plane of 0.3 m x 0.3 m, 2 cm behind the wall.
  EXPECT_EQ (shell().add ({4.02, 1, 0.4}, {0, 0.3, 0}, {0, 0, 0.3}).lastKind(), "wall");
}

TEST (PlaneKinds, OfTwoStoriesAreTwoFloorsAndTwoCeilings)
{
  Rectangles house;
  house.sensor = far_above;
  for (const double floor : {0.0, 2.8}) { // its height
    house.level (floor, 6_m, 5_m).level (floor + 2.5, 6_m, 5_m);
    house.add ({0, 0, floor}, {6, 0, 0}, {0, 0, 2.5});
  }
  EXPECT_EQ (house.kinds(),
             (Names{"floor", "ceiling", "wall", "floor", "ceiling", "wall"}));
}

TEST (PlaneKinds, OfAHouseFromAboveAreGroundWallsAndRoof)
{
  Rectangles house;
  house.sensor = far_above;
  house.level (0.0, 60_m, 40_m, -20.0, -20.0);
  house.add ({0, 0, 0}, {10, 0, 0}, {0, 0, 5}).add ({0, 0, 5}, {10, 0, 0}, {0, 4, 3});
  house.level (5.0, 6_m, 6_m, 20.0, 0.0); // the flat roof of another house
  EXPECT_EQ (house.kinds(), (Names{"floor", "wall", "roof", "roof"}));
}

TEST (PlaneKinds, OfAHillsideIsOther)
{
  // A hillside is a slope whose points are too far from its plane for a roof.
  Rectangles survey;
  survey.sensor = far_above;
  survey.level (0.0, 60_m, 40_m).add ({0, 0, 5}, {30, 0, 0}, {0, 20, 6});
  ASSERT_EQ (survey.lastKind(), "roof");
  PlaneSegment& slope = survey.planes.back();
  const auto setRms = [&slope] (double rms) {
    slope.moments = Moments::of (
        1000.0, slope.centroid, rms * rms * slope.normal * slope.normal.transpose());
  };
  setRms (0.5); // [m]
  EXPECT_EQ (survey.lastKind(), "other") << "too far, whatever the noise";
  setRms (0.2);
  EXPECT_EQ (survey.lastKind(), "roof") << "where the noise is not known";
  slope.noise = 0.05;
  EXPECT_EQ (survey.lastKind(), "other") << "its rms is four noises";
  slope.noise = 0.1;
  EXPECT_EQ (survey.lastKind(), "roof") << "its rms is two noises";
}

TEST (PlaneKinds, OfASlopeThatGoesOnAtItsEndsIsOther)
{
  // A valley of 40 m x 40 m, and a hillside of 20 degrees along y in three strips, each
  // above the one before. A strip begins at this y and is 9 m deep.
  const auto addStrip = [] (Rectangles& hills, double y) {
    constexpr double slope = 0.36; // tan (20 degrees)
    hills.add ({0, y, slope * y}, {40, 0, 0}, {0, 9, slope * 9});
  };
  Rectangles hills;
  hills.sensor = far_above;
  hills.level (0.0, 40_m, 40_m, 0.0, -40.0);
  for (const double y : {0.0, 10.0, 20.0})
    addStrip (hills, y);
  EXPECT_EQ (hills.kinds()[2], "other") << "the middle strip";
  Rectangles roof;
  roof.sensor = far_above;
  roof.level (0.0, 40_m, 40_m, 0.0, -40.0);
  addStrip (roof, 10.0);
  EXPECT_EQ (roof.kinds()[1], "roof") << "the middle strip alone";
}

TEST (PlaneKinds, OfTwoSidesOfAGableAreRoofs)
{
  for (const double rise : {0.5, 4.0}) { // on 4 m: 7 and 45 degrees
    Rectangles house;
    house.sensor = far_above;
    house.level (0.0, 40_m, 40_m, -15.0, -15.0);
    house.add ({0, 0, 3}, {10, 0, 0}, {0, 4, rise});
    house.add ({0, 8, 3}, {10, 0, 0}, {0, -4, rise});
    EXPECT_EQ (house.kinds(), (Names{"floor", "roof", "roof"})) << rise;
  }
}

TEST (PlaneKinds, OfARoofWithoutItsGroundIsARoof)
{
  Rectangles roof;
  roof.sensor = far_above;
  roof.level (0.0, 2_m, 2_m, 30.0, 0.0); // a piece of the ground elsewhere
  roof.add ({0, 0, 5}, {10, 0, 0}, {0, 4, 2});
  roof.add ({0, 8, 5}, {10, 0, 0}, {0, -4, 2});
  EXPECT_EQ (roof.kinds(), (Names{"floor", "roof", "roof"}));
}

TEST (PlaneKinds, OfALevelFieldOnAHillIsOther)
{
  Rectangles terraces; // 10 m deep, each half a meter above the one before
  terraces.sensor = far_above;
  for (const double terrace : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0})
    terraces.level (0.5 * terrace, 30_m, 10_m, 0.0, 10.0 * terrace);
  EXPECT_EQ (terraces.kinds()[5], "other");
}

TEST (PlaneKinds, OfAFieldFarAboveAnotherOneIsAFloor)
{
  Rectangles fields;
  fields.sensor = far_above;
  fields.level (0.0, 60_m, 60_m).level (9.0, 40_m, 60_m, 70.0, 0.0);
  EXPECT_EQ (fields.lastKind(), "floor") << "nothing is below it";
  fields.planes.back().moments =
      Moments::of (1e3,
                   fields.planes.back().centroid,
                   0.2 * Vector3d::UnitZ().asDiagonal().toDenseMatrix());
  EXPECT_EQ (fields.lastKind(), "other") << "a hill, with an rms of 0.45 m";
}

TEST (PlaneKinds, OfACeilingWhoseFloorIsOutOfSightIsACeiling)
{
  Rectangles hall;
  hall.level (6.0, 9_m, 9_m).add ({0, 9, 0}, {9, 0, 0}, {0, 0, 6});
  EXPECT_EQ (hall.kinds(), (Names{"ceiling", "wall"}));
}

TEST (PlaneKinds, OfASlopeUpFromTheFloorIsARamp)
{
  EXPECT_EQ (shell().add ({1, 1, 0}, {1.0, 0, 0.3}, {0, 1.2, 0}).lastKind(), "ramp");
  EXPECT_EQ (shell().add ({1, 1, 0.5}, {1.0, 0, 0.3}, {0, 1.2, 0}).lastKind(), "other")
      << "a desk that is tilted, 0.5 m over the floor";
  EXPECT_EQ (shell().add ({1, 1, 0}, {0.5, 0, 1.0}, {0, 1.2, 0}).lastKind(), "other")
      << "a board that leans, too steep";
}

TEST (PlaneKinds, OfARoadThatFallsIsAFloor)
{
  // By 2 m on 100 m.
  Rectangles road;
  road.add ({0, 0, 1}, {100, 0, -2}, {0, 10, 0});
  EXPECT_EQ (road.kinds(), Names{"floor"});
}

TEST (PlaneKinds, OfARoadAboveTheFootOfAWallIsAFloor)
{
  // The wall begins 1 m below the road, which has 200 m^2.
  Rectangles road;
  road.add ({0, 20, -1}, {20, 0, 0}, {0, 0, 4}).level (0.0, 20_m, 10_m);
  EXPECT_EQ (road.kinds(), (Names{"wall", "floor"}));
}

TEST (PlaneKinds, OfDesksWhoseFloorIsOutOfSightAreTables)
{
  Rectangles office;
  office.add ({0, 3, 0}, {8, 0, 0}, {0, 0, 2.5});
  for (const double x : {0.0, 2.0, 4.0, 6.0})
    office.level (0.75, 1.6_m, 0.8_m, x);
  EXPECT_EQ (office.kinds(), (Names{"wall", "table", "table", "table", "table"}));
}

TEST (PlaneKinds, OfAGalleryIsASlab)
{
  Rectangles hall;
  hall.level (0.0, 9_m, 9_m).level (1.5, 4_m, 3_m).level (6.0, 9_m, 9_m);
  EXPECT_EQ (hall.kinds(), (Names{"floor", "slab", "ceiling"}));
}

TEST (PlaneKinds, OfPlanesBelowTheSensorAreNoCeilings)
{
  Rectangles street;
  street.sensor = {0, 0, 0};
  street.level (-4.0, 4_m, 4_m).level (-2.0, 20_m, 20_m, 5.0, 5.0); // a pit, the street
  EXPECT_EQ (street.kinds().back(), "floor") << "nothing is below it";
  EXPECT_EQ (street.kindsFromSensor().back(), "floor");
  Rectangles bridge;
  bridge.sensor = {0, 0, 0};
  bridge.level (-4.0, 20_m, 20_m, 5.0, 5.0).level (-2.0, 20_m, 20_m, 5.0, 5.0);
  EXPECT_EQ (bridge.kinds().back(), "ceiling") << "the sensor may have been below it";
  EXPECT_NE (bridge.kindsFromSensor().back(), "ceiling");
}

TEST (PlaneKinds, OfALargePlatformInAHallIsASlab)
{
  Rectangles hall;
  hall.level (0.0, 20_m, 20_m).level (1.2, 10_m, 8_m).level (6.0, 20_m, 20_m);
  EXPECT_EQ (hall.kinds(), (Names{"floor", "slab", "ceiling"}));
}

TEST (PlaneKinds, OfAMapDoNotDependOnASensorFarAwayFromIt)
{
  Rectangles map;
  map.sensor = {0, 0, 1e6};
  map.level (0.0, 8_m, 8_m).level (3.0, 8_m, 8_m);
  EXPECT_EQ (map.kindsFromSensor(), (Names{"floor", "ceiling"}));
}

TEST (PlaneKinds, OfPlanesFarBelowASensorDoNotDependOnTheirOrder)
{
  // A level above a floor, and two more floors in a row, 100 m and 200 m away. The
  // sensor is 75 km above: more than 500 times as far as the planes reach from their
  // middle, but less than 500 times as far as they reach from the first one.
  Rectangles map;
  map.sensor = {100, 0, 75e3};
  map.level (0.0, 8_m, 8_m).level (3.0, 8_m, 8_m);
  map.level (0.0, 2_m, 2_m, 100.0).level (0.0, 2_m, 2_m, 200.0);
  const Names kinds = map.kindsFromSensor();
  std::rotate (map.planes.begin(), map.planes.begin() + 2, map.planes.end());
  std::rotate (map.extents.begin(), map.extents.begin() + 2, map.extents.end());
  EXPECT_EQ (map.kindsFromSensor(), (Names{kinds[2], kinds[3], kinds[0], kinds[1]}));
}

TEST (PlaneKinds, OfATerraceBelowTheSensorAndItsWallAreFloorAndWall)
{
  Rectangles terrace;
  terrace.sensor = {5, 5, 6};
  terrace.level (0.0, 20_m, 10_m).level (4.0, 10_m, 10_m);
  terrace.add ({0, 10, 4}, {10, 0, 0}, {0, 0, 3});
  EXPECT_EQ (terrace.kindsFromSensor(), (Names{"floor", "floor", "wall"}));
}

TEST (PlaneKinds, OfAFlatRoofFarBelowTheSensorIsARoof)
{
  Rectangles house;
  house.sensor = {0, 0, 30};
  house.level (0.0, 20_m, 20_m).level (5.0, 10_m, 10_m);
  EXPECT_EQ (house.kindsFromSensor(), (Names{"floor", "roof"}));
}

TEST (PlaneKinds, OfARoomAreTheSameWhereTheSensorIsKnown)
{
  EXPECT_EQ (shell().kindsFromSensor(), shell().kinds());
  Rectangles image = shell();
  image.sensor = {2, 1.5, 2.5}; // in the plane of the ceiling, which it does not see
  EXPECT_EQ (image.kindsFromSensor(), shell().kinds());
}

TEST (PlaneKinds, OfPartsOfTheGroundAtTwoHeightsAreFloors)
{
  Rectangles street;
  street.sensor = {0, 0, 2};
  street.level (0.0, 10_m, 10_m).level (1.0, 20_m, 10_m, 10.0, 0.0);
  EXPECT_EQ (street.kinds(), (Names{"floor", "floor"}));
  EXPECT_EQ (street.kindsFromSensor(), (Names{"floor", "floor"}));
  Rectangles ditch; // its ground goes on below the street
  ditch.sensor = {0, 0, 2};
  ditch.level (0.0, 30_m, 10_m).level (1.0, 20_m, 10_m, 10.0, 0.0);
  EXPECT_EQ (ditch.kinds(), (Names{"floor", "slab"}));
  EXPECT_EQ (ditch.kindsFromSensor(), (Names{"floor", "floor"}));
}

TEST (PlaneKinds, OfARoomAreTheSameForASensorThatLeans)
{
  const Names upright = {"floor", "ceiling", "wall", "wall", "wall", "wall", "table"};
  Rectangles room = shell();
  room.level (0.72, 1.4, 0.8, 1.0, 1.0);
  for (const double degrees : {5.0, 8.0, 11.0}) {
    // The up axis is taken for that of the sensor, which leans.
    const Eigen::AngleAxisd lean (degrees * M_PI / 180.0, Vector3d::UnitX());
    const Vector3d up = lean * Vector3d::UnitZ();
    for (PlaneSegment& plane : room.planes)
      plane.orientation = orientationOf (plane.normal, up, paper_angle_tolerance);
    EXPECT_EQ (room.kindsFromSensor (up), upright) << degrees;
    if (degrees > 7.0) {
      EXPECT_NE (room.kinds (std::nullopt, up).front(), "floor")
          << "without its position it is not known that the sensor leans";
    }
  }
}

TEST (PlaneKinds, OfWallsAreWallsThoughSomeGroundFarAwaySlopes)
{
  Rectangles street;
  street.sensor = {0, 0, 0};
  street.add ({-3, 4, -1}, {6, 0, 0}, {0, 0.3, 3});  // a wall that leans by 6 degrees
  street.add ({40, -3, -4}, {8, 0, 1.2}, {0, 6, 0}); // 48 m^2 that slope by 8 degrees
  EXPECT_EQ (street.kindsFromSensor().front(), "wall");
}

TEST (PlaneKinds, OfWallsAreWallsThoughASlopeIsSeenEdgeOn)
{
  Rectangles street;
  street.sensor = {0, 0, 0};
  street.add ({-3, -3, -1}, {0, 6, 0}, {0, 0, 3});
  // A slope of 8 degrees whose plane goes through the sensor.
  street.add ({2, -3, -0.28}, {16, 0, -2.24}, {0, 6, 0});
  EXPECT_EQ (street.kindsFromSensor().front(), "wall");
}

TEST (PlaneKinds, OfACeilingOfPanelsAtTheHeightOfTheSensorAreCeilings)
{
  Rectangles room;
  room.sensor.z() = 2.5;
  room.level (0.0, 3_m, 3_m);
  for (const double x : {0.0, 1.0, 2.0, 3.0})
    room.level (2.5, 0.9, 0.9, x);
  EXPECT_EQ (room.kindsFromSensor(),
             (Names{"floor", "ceiling", "ceiling", "ceiling", "ceiling"}));
}

TEST (PlaneKinds, OfASlopeBesideASmallerLevelFloorIsARamp)
{
  Rectangles garage;
  garage.level (0.0, 4_m, 5_m).add ({4, 0, 0}, {10, 0, 1.4}, {0, 5, 0});
  garage.sensor = {2, 2, 2};
  EXPECT_EQ (garage.kindsFromSensor(), (Names{"floor", "ramp"}));
}

TEST (PlaneKinds, OfNoPlanesAreNone)
{
  EXPECT_TRUE (planeKinds ({}, {}, Vector3d::UnitZ()).empty());
}

TEST (PlaneKinds, RefuseMissingExtentsAndInvalidParameters)
{
  const Rectangles room = shell();
  const Vector3d up = Vector3d::UnitZ();
  EXPECT_THROW (planeKinds (room.planes, {}, up), std::invalid_argument);
  EXPECT_THROW (planeKinds (room.planes, room.extents, {0, 0, 0}),
                std::invalid_argument);
  EXPECT_THROW (planeKinds (room.planes, room.extents, up, 0.0), std::invalid_argument);
  EXPECT_THROW (planeKinds (room.planes, room.extents, up, 1.0, Vector3d (0, NAN, 0)),
                std::invalid_argument);
}

TEST (PlaneKinds, RefusePlanesWhoseHeightIsNotFinite)
{
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  Rectangles room = shell();
  const Vector3d up = Vector3d::UnitZ();
  EXPECT_THROW (planeKinds (room.planes, room.extents, up, 1e-320),
                std::invalid_argument)
      << "a meter so short that heights in meters are infinite";
  room.planes[0].centroid.z() = not_a_number;
  EXPECT_THROW (planeKinds (room.planes, room.extents, up), std::invalid_argument);
}

TEST (PlaneKinds, RefuseExtentsWhoseHullIsNotFinite)
{
  const Vector3d up = Vector3d::UnitZ();
  for (const double value : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    Rectangles room = shell();
    room.extents[0].hull[1].x() = value;
    EXPECT_THROW (planeKinds (room.planes, room.extents, up), std::invalid_argument)
        << value;
  }
}

TEST (PlaneKinds, FollowAnUpAxisOfAnyLength)
{
  const Rectangles room = shell();
  const std::vector<PlaneKind> kinds =
      planeKinds (room.planes, room.extents, Vector3d::UnitZ());
  for (const double length : {1e-320, 1e300})
    EXPECT_EQ (planeKinds (room.planes, room.extents, {0, 0, length}), kinds) << length;
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// The limits in the table of src/doc/buildings.md, each tested from both sides.
#include "rectangles.h"

#include <cmath>
#include <functional>

namespace {

/** \brief The kind of the last plane of a scene below and above a limit. */
struct Limit {
  std::string of;
  double limit;
  std::string below, above;
  std::function<std::string (double)> kind;
};

void
expectLimits (const std::vector<Limit>& limits)
{
  constexpr double beside = 0.05;
  for (const Limit& limit : limits) {
    EXPECT_EQ (limit.kind ((1.0 - beside) * limit.limit), limit.below) << limit.of;
    EXPECT_EQ (limit.kind ((1.0 + beside) * limit.limit), limit.above) << limit.of;
  }
}

/** \brief A floor of 4 m x 3 m and nothing else. */
Rectangles
floor4By3 ()
{
  return Rectangles().level (0.0, 4_m, 3_m);
}

/** \brief Seen from nowhere: all normals point up. */
Rectangles
survey ()
{
  Rectangles survey;
  survey.sensor = {0, 0, 1e3};
  return survey.level (0.0, 60_m, 40_m, -20.0, -20.0);
}

Vector3d
upwards (double length, double degrees)
{
  const double angle = degrees * M_PI / 180.0;
  return {length * std::cos (angle), 0.0, length * std::sin (angle)};
}

/** \brief A board of 0.6 m, too narrow for a wall by itself, in a room of 2.5 m. */
std::string
board (Rectangles room, double low, double high)
{
  return room.add ({1, 1, low}, {0.6, 0, 0}, {0, 0, high - low}).lastKind();
}

} // namespace

TEST (KindLimits, OfTables)
{
  const auto top = [] (double height, double length, double width) {
    Rectangles room = shell();
    room.sensor.z() = 2.0; // sees tops of counters
    return room.level (height, length, width, 1.0, 1.0).lastKind();
  };
  expectLimits ({{"height of seats",
                  0.3,
                  "other",
                  "table",
                  [&] (double v) { return top (v, 0.8, 0.8); }},
                 {"height of counters",
                  1.3,
                  "table",
                  "other",
                  [&] (double v) { return top (v, 0.8, 0.8); }},
                 {"smallest",
                  0.1,
                  "other",
                  "table",
                  [&] (double v) { return top (0.7, 4.0 * v, 0.25); }},
                 {"largest",
                  6.0,
                  "table",
                  "slab",
                  [&] (double v) { return top (0.7, 3.0, v / 3.0); }},
                 {"narrowest", 0.2, "other", "table", [&] (double v) {
                    return top (0.7, 1.5, v);
                  }}});
}

TEST (KindLimits, OfFloorsAndSlabs)
{
  const auto level = [] (double height, double length, double width) {
    return shell().level (height, length, width, 1.0, 1.0).lastKind();
  };
  expectLimits ({{"a sill",
                  0.1,
                  "floor",
                  "other",
                  [&] (double v) { return level (v, 0.5, 0.5); }},
                 {"a step",
                  0.3,
                  "floor",
                  "table",
                  [&] (double v) { return level (v, 2.0, 1.0); }},
                 {"area of a step",
                  1.0,
                  "other",
                  "floor",
                  [&] (double v) { return level (0.2, 1.0, v); }},
                 {"area of a slab", 2.0, "other", "slab", [&] (double v) {
                    return level (1.5, 2.0, 0.5 * v);
                  }}});
}

TEST (KindLimits, OfTheLowestFloor)
{
  const auto above_foot = [] (double area_of_foot, double area) {
    Rectangles scene;
    scene.level (0.0, 10.0, 0.1 * area);
    scene.add ({0, 20, -1}, {area_of_foot, 0, 0}, {0, 0, 1});
    return scene.kinds().front();
  };
  expectLimits ({{"what says how deep a scene is",
                  0.3,
                  "floor",
                  "slab",
                  [&] (double v) { return above_foot (v, 12.0); }},
                 {"ground", 50.0, "slab", "floor", [&] (double v) {
                    return above_foot (1.0, v);
                  }}});
}

TEST (KindLimits, OfCeilings)
{
  const auto part =
      [] (double below, double length, double width, const Vector3d& sensor) {
        Rectangles hall;
        hall.sensor = sensor;
        hall.level (0.0, 4_m, 3_m).level (3.5, 4_m, 3_m);
        return hall.level (3.5 - below, length, width).lastKind();
      };
  const Vector3d below (2.0, 1.5, 1.2);
  const Vector3d nowhere (0.0, 0.0, 1e3);
  const auto alone = [] (double height, double length, double width) {
    return floor4By3().level (height, length, width).lastKind();
  };
  expectLimits ({{"a beam",
                  0.6,
                  "ceiling",
                  "other",
                  [&] (double v) { return part (v, 1.0, 1.0, below); }},
                 {"area of a beam",
                  0.3,
                  "other",
                  "ceiling",
                  [&] (double v) { return part (0.3, 1.0, v, below); }},
                 {"what may be seen from above",
                  0.15,
                  "ceiling",
                  "other",
                  [&] (double v) { return part (v, 1.0, 1.0, nowhere); }},
                 {"headroom",
                  1.9,
                  "other",
                  "ceiling",
                  [&] (double v) { return alone (v, 1.2, 1.0); }},
                 {"area alone",
                  1.0,
                  "other",
                  "ceiling",
                  [&] (double v) { return alone (2.1, 1.0, v); }},
                 {"above cupboards",
                  2.3,
                  "other",
                  "ceiling",
                  [&] (double v) { return alone (v, 0.5, 0.5); }},
                 {"area above cupboards", 0.1, "other", "ceiling", [&] (double v) {
                    return alone (2.6, 4.0 * v, 0.25);
                  }}});
}

TEST (KindLimits, OfStories)
{
  const auto board_below = [] (double floor, double length, double width) {
    Rectangles room;
    room.level (0.0, floor, floor).level (2.5, length, width);
    return board (room, 1.0, 2.4);
  };
  const auto top = [] (double share) {
    Rectangles house;
    house.sensor = {0, 0, 1e3};
    return house.level (0.0, 4_m, 3_m).level (2.5, 4_m, 3.0 * share).lastKind();
  };
  const auto deck = [] (double thickness) {
    Rectangles house;
    house.sensor = {0, 0, 1e3};
    house.level (0.0, 4_m, 3_m).level (2.5 + thickness, 4_m, 3_m);
    return house.level (2.5, 4_m, 3_m).lastKind();
  };
  expectLimits ({{"area of a level",
                  1.0,
                  "other",
                  "wall",
                  [&] (double v) { return board_below (2.0, 1.0, v); }},
                 {"share of the largest",
                  0.2,
                  "other",
                  "wall",
                  [&] (double v) { return board_below (4.0, 4.0, 4.0 * v); }},
                 {"share of the floor", 1.0 / 3.0, "roof", "ceiling", top},
                 {"a deck", 0.8, "ceiling", "roof", deck}});
}

TEST (KindLimits, OfWalls)
{
  const auto wall = [] (double width, double height) {
    return floor4By3().add ({0, 3, 0}, {width, 0, 0}, {0, 0, height}).lastKind();
  };
  const auto front = [] (double before, double degrees) {
    const double angle = degrees * M_PI / 180.0;
    const Vector3d along (std::cos (angle), std::sin (angle), 0.0);
    return shell().add ({1, before, 0}, 1.2 * along, {0, 0, 1.8}).lastKind();
  };
  expectLimits (
      {{"height", 1.3, "other", "wall", [&] (double v) { return wall (2.0, v); }},
       {"width", 1.0, "other", "wall", [&] (double v) { return wall (v, 1.6); }},
       {"gap below the ceiling",
        0.3,
        "wall",
        "other",
        [] (double v) { return board (shell(), 1.0, 2.5 - v); }},
       {"part at the ceiling",
        0.5,
        "other",
        "wall",
        [] (double v) { return board (shell(), 2.5 - v, 2.5); }},
       {"depth of reliefs",
        0.1,
        "wall",
        "other",
        [&] (double v) { return front (v, 0.0); }},
       {"depth of furniture",
        1.0,
        "other",
        "wall",
        [&] (double v) { return front (v, 0.0); }},
       {"turn of furniture", 25.8, "other", "wall", [&] (double v) {
          return front (0.3, v);
        }}});
}

TEST (KindLimits, OfPartsOfWalls)
{
  const auto part = [] (double behind, double degrees) {
    const double angle = degrees * M_PI / 180.0;
    const Vector3d along (0.3 * std::sin (angle), 0.3 * std::cos (angle), 0.0);
    return shell()
        .add (Vector3d (4.0 + behind, 1, 0.4) - 0.5 * along, along, {0, 0, 0.3})
        .lastKind();
  };
  expectLimits (
      {{"distance", 0.1, "wall", "other", [&] (double v) { return part (v, 0.0); }},
       {"turn", 9.94, "wall", "other", [&] (double v) { return part (0.0, v); }}});
}

TEST (KindLimits, OfRamps)
{
  const auto ramp = [] (double length, double degrees, double width, double from) {
    return shell()
        .add ({1, 1, from}, upwards (length, degrees), {0, width, 0})
        .lastKind();
  };
  const auto long_ramp = [] (double degrees) {
    Rectangles hall;
    hall.level (0.0, 30_m, 5_m);
    return hall.add ({1, 1, 0}, upwards (16.0, degrees), {0, 1.2, 0}).lastKind();
  };
  expectLimits (
      {{"flattest", 2.5, "slab", "ramp", long_ramp},
       {"steepest",
        35.0,
        "ramp",
        "other",
        [&] (double v) { return ramp (1.0, v, 1.2, 0.0); }},
       {"area",
        0.5,
        "other",
        "ramp",
        [&] (double v) { return ramp (1.0, 15.0, v, 0.0); }},
       {"rise",
        0.15,
        "other",
        "ramp",
        [&] (double v) { return ramp (v / std::sin (M_PI / 12.0), 15.0, 1.2, 0.0); }},
       {"where it begins", 0.2, "ramp", "other", [&] (double v) {
          return ramp (1.0, 15.0, 1.2, v);
        }}});
}

TEST (KindLimits, OfRoofs)
{
  const auto sloping = [] (double middle, double area) {
    const double depth = 0.8 * area / 4.0; // at 3 : 4 : 5
    return survey()
        .add ({0, 0, middle - 0.375 * depth}, {4, 0, 0}, {0, depth, 0.75 * depth})
        .lastKind();
  };
  const auto upper_level = [] (double wall_from, double wall_to) {
    Rectangles house;
    house.sensor = {0, 0, 1e3};
    house.level (0.0, 6_m, 5_m).level (2.5, 6_m, 5_m);
    house.add ({0, 0, 2.8 + wall_from}, {6, 0, 0}, {0, 0, wall_to - wall_from});
    return house.level (2.8, 6_m, 5_m).lastKind();
  };
  const auto bent = [] (double rms, std::optional<double> noise) {
    Rectangles scene = survey();
    scene.add ({0, 0, 5}, {8, 0, 0}, {0, 4, 3});
    PlaneSegment& roof = scene.planes.back();
    roof.moments = Moments::of (
        1000.0, roof.centroid, rms * rms * roof.normal * roof.normal.transpose());
    roof.noise = noise;
    return scene.lastKind();
  };
  expectLimits (
      {{"area", 2.0, "other", "roof", [&] (double v) { return sloping (5.0, v); }},
       {"height", 1.9, "other", "roof", [&] (double v) { return sloping (v, 8.0); }},
       {"a wall that rises from it",
        0.3,
        "floor",
        "roof",
        [&] (double v) { return upper_level (v, 3.0); }},
       {"height of that wall",
        1.9,
        "roof",
        "floor",
        [&] (double v) { return upper_level (0.0, v); }},
       {"relief", 0.35, "roof", "other", [&] (double v) { return bent (v, {}); }},
       {"relief over the noise", 0.15, "roof", "other", [&] (double v) {
          return bent (v, 0.05);
        }}});
}

TEST (KindLimits, OfFurnitureBeforeWalls)
{
  // The front of a cupboard 1.8 m high, before a wall of this height and width.
  const auto front = [] (double wall_height, double wall_width) {
    Rectangles room = floor4By3();
    room.add ({0, 3, 0}, {wall_width, 0, 0}, {0, 0, wall_height});
    return room.add ({0, 2.6, 0}, {1.5, 0, 0}, {0, 0, 1.8}).lastKind();
  };
  expectLimits ({{"height of the wall",
                  1.8,
                  "wall",
                  "other",
                  [&] (double v) { return front (v, 4.0); }},
                 {"area of the wall", 2.7, "wall", "other", [&] (double v) {
                    return front (2.4, v / 2.4);
                  }}});
}

TEST (KindLimits, OfASensorThatLeans)
{
  // Ground of 10 degrees, 2 m below the sensor, and what else is at that height.
  const auto ground_beside = [] (double degrees, const Vector3d& place, double area) {
    Rectangles room;
    room.sensor = {0, 0, 0};
    const Eigen::AngleAxisd lean (degrees * M_PI / 180.0, Vector3d::UnitX());
    const Vector3d depth = lean * Vector3d (0, 3, 0);
    room.add (Vector3d (1, 0, -2) - 0.5 * depth, {4, 0, 0}, depth);
    const Vector3d side (0.0, area / 4.0, 0.0);
    return room.add (place - 0.5 * side, {4, 0, 0}, side);
  };
  const auto beside_level = [&] (double share) {
    return ground_beside (10.0, {-5, 0, -2}, 12.0 * share).kindsFromSensor().front();
  };
  const auto up_the_slope = [] (double degrees) {
    Rectangles road;
    road.sensor = {0, 0, 0};
    const Eigen::AngleAxisd lean (degrees * M_PI / 180.0, Vector3d::UnitX());
    for (const double from : {-2.0, 10.0})
      road.add (Vector3d (1, 0, -2) + lean * Vector3d (0, from, 0),
                {2, 0, 0},
                lean * Vector3d (0, 4, 0));
    return road.kindsFromSensor().back();
  };
  expectLimits ({{"level beside it", 0.2, "floor", "other", beside_level},
                 {"least", 3.0, "slab", "floor", up_the_slope}});
}

TEST (KindLimits, OfTheGroundOfASensorThatLeans)
{
  // A floor of 12 m2 under a sensor that leans, and a wall that does so with it.
  const auto kind = [] (double degrees, double area, double height) {
    Rectangles room;
    room.sensor = {0.5, 0.5, height};
    const Eigen::AngleAxisd lean (degrees * M_PI / 180.0, Vector3d::UnitX());
    room.add ({0, 0, 0}, {1, 0, 0}, lean * Vector3d (0, area, 0));
    return room.kindsFromSensor().back();
  };
  expectLimits ({{"largest",
                  12.0,
                  "floor",
                  "ramp",
                  [&] (double v) { return kind (v, 12.0, 2.0); }},
                 {"ground", 4.0, "ramp", "floor", [&] (double v) {
                    return kind (10.0, v, 2.0);
                  }}});
}

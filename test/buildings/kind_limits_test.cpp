// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// The limits in the table of src/doc/buildings.md, each tested from both sides.
#include "rectangles.h"

#include <cmath>
#include <functional>

namespace {

/** \brief A limit of a quantity, and the kinds of a plane below it and above it. */
struct Limit {
  std::string of;
  double limit;
  std::string kind_below, kind_above;
  /** \brief Returns the kind of the plane for a value of the quantity. */
  std::function<std::string (double)> kind;
};

/** \brief Fails unless planes have these kinds 5 % below and 5 % above each limit. */
void
expectLimits (const std::vector<Limit>& limits)
{
  constexpr double share = 0.05;
  for (const Limit& limit : limits) {
    EXPECT_EQ (limit.kind ((1.0 - share) * limit.limit), limit.kind_below) << limit.of;
    EXPECT_EQ (limit.kind ((1.0 + share) * limit.limit), limit.kind_above) << limit.of;
  }
}

/** \brief A floor of 4 m x 3 m and nothing else. */
Rectangles
floor4By3 ()
{
  return Rectangles().level (0.0, 4_m, 3_m);
}

/** \brief A sensor far above: all normals point up. */
const Vector3d sensor_far_above (0.0, 0.0, 1e3);

/** \brief A ground of 60 m x 40 m seen from above. */
Rectangles
survey ()
{
  Rectangles survey;
  survey.sensor = sensor_far_above;
  return survey.level (0.0, 60_m, 40_m, -20.0, -20.0);
}

/** \brief A direction along x that rises by an angle, with this length [m]. */
Vector3d
upwards (double length, double degrees)
{
  const double angle = degrees * M_PI / 180.0;
  return {length * std::cos (angle), 0.0, length * std::sin (angle)};
}

/** \brief The kind of an upright board in a room that is 2.5 m high. The board is 0.6 m
 * wide, too narrow for a wall by itself.
 * \param[in] low,high heights of its lower and its upper edge [m] */
std::string
kindOfBoard (Rectangles room, double low, double high)
{
  return room.add ({1, 1, low}, {0.6, 0, 0}, {0, 0, high - low}).lastKind();
}

} // namespace

TEST (KindLimits, OfTables)
{
  const auto kindOfTop = [] (double height, double length, double width) {
    Rectangles room = shell();
    room.sensor.z() = 2.0; // sees tops of counters
    return room.level (height, length, width, 1.0, 1.0).lastKind();
  };
  expectLimits ({{"height of seats",
                  0.3,
                  "other",
                  "table",
                  [&] (double v) { return kindOfTop (v, 0.8, 0.8); }},
                 {"height of counters",
                  1.3,
                  "table",
                  "other",
                  [&] (double v) { return kindOfTop (v, 0.8, 0.8); }},
                 {"smallest",
                  0.1,
                  "other",
                  "table",
                  [&] (double v) { return kindOfTop (0.7, 4.0 * v, 0.25); }},
                 {"largest",
                  6.0,
                  "table",
                  "slab",
                  [&] (double v) { return kindOfTop (0.7, 3.0, v / 3.0); }},
                 {"narrowest", 0.2, "other", "table", [&] (double v) {
                    return kindOfTop (0.7, 1.5, v);
                  }}});
}

TEST (KindLimits, OfFloorsAndSlabs)
{
  const auto kindOfLevel = [] (double height, double length, double width) {
    return shell().level (height, length, width, 1.0, 1.0).lastKind();
  };
  expectLimits ({{"a sill",
                  0.1,
                  "floor",
                  "other",
                  [&] (double v) { return kindOfLevel (v, 0.5, 0.5); }},
                 {"a step",
                  0.3,
                  "floor",
                  "table",
                  [&] (double v) { return kindOfLevel (v, 2.0, 1.0); }},
                 {"area of a step",
                  1.0,
                  "other",
                  "floor",
                  [&] (double v) { return kindOfLevel (0.2, 1.0, v); }},
                 {"area of a slab", 2.0, "other", "slab", [&] (double v) {
                    return kindOfLevel (1.5, 2.0, 0.5 * v);
                  }}});
}

TEST (KindLimits, OfTheLowestFloor)
{
  // The kind of a level of this area, 1 m above the foot of an upright plane.
  const auto kindAboveFoot = [] (double area_of_upright, double area) {
    Rectangles scene;
    scene.level (0.0, 10.0, 0.1 * area);
    scene.add ({0, 20, -1}, {area_of_upright, 0, 0}, {0, 0, 1});
    return scene.kinds().front();
  };
  expectLimits ({{"what says how deep a scene is",
                  0.3,
                  "floor",
                  "slab",
                  [&] (double v) { return kindAboveFoot (v, 12.0); }},
                 {"ground", 50.0, "slab", "floor", [&] (double v) {
                    return kindAboveFoot (1.0, v);
                  }}});
}

TEST (KindLimits, OfCeilings)
{
  // The kind of a level below a ceiling of 3.5 m.
  const auto kindBelowCeiling =
      [] (double below, double length, double width, const Vector3d& sensor) {
        Rectangles hall;
        hall.sensor = sensor;
        hall.level (0.0, 4_m, 3_m).level (3.5, 4_m, 3_m);
        return hall.level (3.5 - below, length, width).lastKind();
      };
  const Vector3d in_the_hall (2.0, 1.5, 1.2);
  // The kind of a level above a floor without a ceiling.
  const auto kindAlone = [] (double height, double length, double width) {
    return floor4By3().level (height, length, width).lastKind();
  };
  expectLimits (
      {{"a beam",
        0.6,
        "ceiling",
        "other",
        [&] (double v) { return kindBelowCeiling (v, 1.0, 1.0, in_the_hall); }},
       {"area of a beam",
        0.3,
        "other",
        "ceiling",
        [&] (double v) { return kindBelowCeiling (0.3, 1.0, v, in_the_hall); }},
       {"what may be seen from above",
        0.15,
        "ceiling",
        "other",
        [&] (double v) { return kindBelowCeiling (v, 1.0, 1.0, sensor_far_above); }},
       {"headroom",
        1.9,
        "other",
        "ceiling",
        [&] (double v) { return kindAlone (v, 1.2, 1.0); }},
       {"area alone",
        1.0,
        "other",
        "ceiling",
        [&] (double v) { return kindAlone (2.1, 1.0, v); }},
       {"above cupboards",
        2.3,
        "other",
        "ceiling",
        [&] (double v) { return kindAlone (v, 0.5, 0.5); }},
       {"area above cupboards", 0.1, "other", "ceiling", [&] (double v) {
          return kindAlone (2.6, 4.0 * v, 0.25);
        }}});
}

TEST (KindLimits, OfStories)
{
  // The kind of a board that ends 10 cm below a level of 2.5 m.
  const auto kindBelowLevel = [] (double floor, double length, double width) {
    Rectangles room;
    room.level (0.0, floor, floor).level (2.5, length, width);
    return kindOfBoard (room, 1.0, 2.4);
  };
  // The kind of a level above a share of the floor.
  const auto kindAboveShare = [] (double share) {
    Rectangles house;
    house.sensor = sensor_far_above;
    return house.level (0.0, 4_m, 3_m).level (2.5, 4_m, 3.0 * share).lastKind();
  };
  // The kind of the lower side of a deck.
  const auto kindOfLowerSide = [] (double thickness) {
    Rectangles house;
    house.sensor = sensor_far_above;
    house.level (0.0, 4_m, 3_m).level (2.5 + thickness, 4_m, 3_m);
    return house.level (2.5, 4_m, 3_m).lastKind();
  };
  expectLimits ({{"area of a level",
                  1.0,
                  "other",
                  "wall",
                  [&] (double v) { return kindBelowLevel (2.0, 1.0, v); }},
                 {"share of the largest",
                  0.2,
                  "other",
                  "wall",
                  [&] (double v) { return kindBelowLevel (4.0, 4.0, 4.0 * v); }},
                 {"share of the floor", 1.0 / 3.0, "roof", "ceiling", kindAboveShare},
                 {"a deck", 0.8, "ceiling", "roof", kindOfLowerSide}});
}

TEST (KindLimits, OfWalls)
{
  const auto kindOfUpright = [] (double width, double height) {
    return floor4By3().add ({0, 3, 0}, {width, 0, 0}, {0, 0, height}).lastKind();
  };
  // The kind of a front before a wall, turned out of its direction. Furniture turns by
  // acos (0.9) = 25.8 degrees at most.
  const auto kindOfFront = [] (double before, double degrees) {
    const double angle = degrees * M_PI / 180.0;
    const Vector3d along (std::cos (angle), std::sin (angle), 0.0);
    return shell().add ({1, before, 0}, 1.2 * along, {0, 0, 1.8}).lastKind();
  };
  expectLimits ({{"height",
                  1.3,
                  "other",
                  "wall",
                  [&] (double v) { return kindOfUpright (2.0, v); }},
                 {"width",
                  1.0,
                  "other",
                  "wall",
                  [&] (double v) { return kindOfUpright (v, 1.6); }},
                 {"gap below the ceiling",
                  0.3,
                  "wall",
                  "other",
                  [] (double v) { return kindOfBoard (shell(), 1.0, 2.5 - v); }},
                 {"part at the ceiling",
                  0.5,
                  "other",
                  "wall",
                  [] (double v) { return kindOfBoard (shell(), 2.5 - v, 2.5); }},
                 {"depth of reliefs",
                  0.1,
                  "wall",
                  "other",
                  [&] (double v) { return kindOfFront (v, 0.0); }},
                 {"depth of furniture",
                  1.0,
                  "other",
                  "wall",
                  [&] (double v) { return kindOfFront (v, 0.0); }},
                 {"turn of furniture", 25.8, "other", "wall", [&] (double v) {
                    return kindOfFront (0.3, v);
                  }}});
}

TEST (KindLimits, OfPartsOfWalls)
{
  // The kind of a small plane behind a wall, turned out of its direction. Parts of
  // walls turn by acos (0.985) = 9.94 degrees at most.
  const auto kindOfPart = [] (double behind, double degrees) {
    const double angle = degrees * M_PI / 180.0;
    const Vector3d along (0.3 * std::sin (angle), 0.3 * std::cos (angle), 0.0);
    return shell()
        .add (Vector3d (4.0 + behind, 1, 0.4) - 0.5 * along, along, {0, 0, 0.3})
        .lastKind();
  };
  expectLimits ({{"distance",
                  0.1,
                  "wall",
                  "other",
                  [&] (double v) { return kindOfPart (v, 0.0); }},
                 {"turn", 9.94, "wall", "other", [&] (double v) {
                    return kindOfPart (0.0, v);
                  }}});
}

TEST (KindLimits, OfRamps)
{
  const auto kindOfRamp =
      [] (double length, double degrees, double width, double from) {
        return shell()
            .add ({1, 1, from}, upwards (length, degrees), {0, width, 0})
            .lastKind();
      };
  const auto kindOfLongRamp = [] (double degrees) {
    Rectangles hall;
    hall.level (0.0, 30_m, 5_m);
    return hall.add ({1, 1, 0}, upwards (16.0, degrees), {0, 1.2, 0}).lastKind();
  };
  expectLimits ({{"flattest", 2.5, "slab", "ramp", kindOfLongRamp},
                 {"steepest",
                  35.0,
                  "ramp",
                  "other",
                  [&] (double v) { return kindOfRamp (1.0, v, 1.2, 0.0); }},
                 {"area",
                  0.5,
                  "other",
                  "ramp",
                  [&] (double v) { return kindOfRamp (1.0, 15.0, v, 0.0); }},
                 {"rise",
                  0.15,
                  "other",
                  "ramp",
                  [&] (double v) {
                    return kindOfRamp (v / std::sin (M_PI / 12.0), 15.0, 1.2, 0.0);
                  }},
                 {"where it begins", 0.2, "ramp", "other", [&] (double v) {
                    return kindOfRamp (1.0, 15.0, 1.2, v);
                  }}});
}

TEST (KindLimits, OfRoofs)
{
  // The kind of a slope 4 m wide, with its middle at this height. It rises by 3 m on 4
  // m, so that seen from above it is 0.8 times as deep as it is long.
  const auto kindOfSlope = [] (double middle, double area) {
    const double depth = 0.8 * area / 4.0;
    return survey()
        .add ({0, 0, middle - 0.375 * depth}, {4, 0, 0}, {0, depth, 0.75 * depth})
        .lastKind();
  };
  // The kind of a level 0.3 m above a ceiling, with a wall from and to these heights
  // above the level.
  const auto kindOfUpperLevel = [] (double wall_from, double wall_to) {
    Rectangles house;
    house.sensor = sensor_far_above;
    house.level (0.0, 6_m, 5_m).level (2.5, 6_m, 5_m);
    house.add ({0, 0, 2.8 + wall_from}, {6, 0, 0}, {0, 0, wall_to - wall_from});
    return house.level (2.8, 6_m, 5_m).lastKind();
  };
  const auto kindOfRough = [] (double rms, std::optional<double> noise) {
    Rectangles scene = survey();
    scene.add ({0, 0, 5}, {8, 0, 0}, {0, 4, 3});
    PlaneSegment& roof = scene.planes.back();
    roof.moments = Moments::of (
        1000.0, roof.centroid, rms * rms * roof.normal * roof.normal.transpose());
    roof.noise = noise;
    return scene.lastKind();
  };
  expectLimits (
      {{"area", 2.0, "other", "roof", [&] (double v) { return kindOfSlope (5.0, v); }},
       {"height",
        1.9,
        "other",
        "roof",
        [&] (double v) { return kindOfSlope (v, 8.0); }},
       {"a wall that rises from it",
        0.3,
        "floor",
        "roof",
        [&] (double v) { return kindOfUpperLevel (v, 3.0); }},
       {"height of that wall",
        1.9,
        "roof",
        "floor",
        [&] (double v) { return kindOfUpperLevel (0.0, v); }},
       {"relief",
        0.35,
        "roof",
        "other",
        [&] (double v) { return kindOfRough (v, {}); }},
       {"relief over the noise", 0.15, "roof", "other", [&] (double v) {
          return kindOfRough (v, 0.05);
        }}});
}

TEST (KindLimits, OfFurnitureBeforeWalls)
{
  // The kind of the front of a cupboard 1.8 m high, before a wall of this height and
  // width.
  const auto kindOfFront = [] (double wall_height, double wall_width) {
    Rectangles room = floor4By3();
    room.add ({0, 3, 0}, {wall_width, 0, 0}, {0, 0, wall_height});
    return room.add ({0, 2.6, 0}, {1.5, 0, 0}, {0, 0, 1.8}).lastKind();
  };
  expectLimits ({{"height of the wall",
                  1.8,
                  "wall",
                  "other",
                  [&] (double v) { return kindOfFront (v, 4.0); }},
                 {"area of the wall", 2.7, "wall", "other", [&] (double v) {
                    return kindOfFront (2.4, v / 2.4);
                  }}});
}

TEST (KindLimits, OfASensorThatLeans)
{
  // A ground of 12 m^2 that slopes, 2 m below the sensor, and a level plane somewhere.
  const auto groundBeside = [] (double degrees, const Vector3d& middle, double area) {
    Rectangles room;
    room.sensor = {0, 0, 0};
    const Eigen::AngleAxisd lean (degrees * M_PI / 180.0, Vector3d::UnitX());
    const Vector3d depth = lean * Vector3d (0, 3, 0);
    room.add (Vector3d (1, 0, -2) - 0.5 * depth, {4, 0, 0}, depth);
    const Vector3d side (0.0, area / 4.0, 0.0);
    return room.add (middle - 0.5 * side, {4, 0, 0}, side);
  };
  const auto kindBesideLevel = [&] (double share) {
    return groundBeside (10.0, {-5, 0, -2}, 12.0 * share).kindsFromSensor().front();
  };
  const auto kindUpTheSlope = [] (double degrees) {
    Rectangles road;
    road.sensor = {0, 0, 0};
    const Eigen::AngleAxisd lean (degrees * M_PI / 180.0, Vector3d::UnitX());
    for (const double from : {-2.0, 10.0})
      road.add (Vector3d (1, 0, -2) + lean * Vector3d (0, from, 0),
                {2, 0, 0},
                lean * Vector3d (0, 4, 0));
    return road.kindsFromSensor().back();
  };
  expectLimits ({{"level beside it", 0.2, "floor", "other", kindBesideLevel},
                 {"least", 3.0, "slab", "floor", kindUpTheSlope}});
}

TEST (KindLimits, OfTheGroundOfASensorThatLeans)
{
  // A ground under a sensor; it leans relative to the sensor by an angle.
  const auto kindOfGround = [] (double degrees, double area, double height) {
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
                  [&] (double v) { return kindOfGround (v, 12.0, 2.0); }},
                 {"ground", 4.0, "ramp", "floor", [&] (double v) {
                    return kindOfGround (10.0, v, 2.0);
                  }}});
}

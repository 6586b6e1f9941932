// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Limits of src/buildings/constants.h at which planes change their kind, each tested
// from both sides. src/doc/buildings.md has the rules.
#include "rectangles.h"

#include <cmath>
#include <functional>

namespace {

/** \brief A limit of a quantity, and the kinds that a plane has for values below it and
 * above it. */
struct Limit {
  std::string quantity;
  double limit;
  std::string kind_below, kind_above;
  /** \brief Returns the kind of the plane for a value of the quantity. */
  std::function<std::string (double)> kindFor;
};

/** \brief Fails unless planes have these kinds 5 % below and 5 % above each limit. */
void
expectLimits (const std::vector<Limit>& limits)
{
  constexpr double share = 0.05; // of the limit
  for (const Limit& limit : limits) {
    EXPECT_EQ (limit.kindFor ((1.0 - share) * limit.limit), limit.kind_below)
        << limit.quantity;
    EXPECT_EQ (limit.kindFor ((1.0 + share) * limit.limit), limit.kind_above)
        << limit.quantity;
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

/** \brief The vector of this length [m] that goes along x and rises by an angle. */
Vector3d
risingAlongX (double length, double degrees)
{
  const double angle = degrees * M_PI / 180.0;
  return {length * std::cos (angle), 0.0, length * std::sin (angle)};
}

/** \brief The kind of an upright board in a room. The board is 0.6 m wide: too narrow
 * for a wall, unless it reaches the ceiling.
 * \param[in] low,high heights of its lower and its upper edge [m] */
std::string
kindOfBoard (Rectangles room, double low, double high)
{
  return room.add ({1, 1, low}, {0.6, 0, 0}, {0, 0, high - low}).lastKind();
}

} // namespace

TEST (KindLimits, OfTables)
{
  // The kind of a level in a room, seen from above.
  const auto kindOfTop = [] (double height, double length, double width) {
    Rectangles room = shell();
    room.sensor.z() = 2.0; // above the tops of counters
    return room.level (height, length, width, 1.0, 1.0).lastKind();
  };
  expectLimits (
      {{"least height of a seat [m]",
        0.3,
        "other",
        "table",
        [&] (double height) { return kindOfTop (height, 0.8, 0.8); }},
       {"largest height of a counter [m]",
        1.3,
        "table",
        "other",
        [&] (double height) { return kindOfTop (height, 0.8, 0.8); }},
       {"least area of a table [m^2]",
        0.1,
        "other",
        "table",
        [&] (double area) { return kindOfTop (0.7, 4.0 * area, 0.25); }},
       {"largest area of a table [m^2]",
        6.0,
        "table",
        "slab",
        [&] (double area) { return kindOfTop (0.7, 3.0, area / 3.0); }},
       {"least width of a table [m]", 0.2, "other", "table", [&] (double width) {
          return kindOfTop (0.7, 1.5, width);
        }}});
}

TEST (KindLimits, OfFloorsAndSlabs)
{
  // The kind of a level in a room.
  const auto kindOfLevel = [] (double height, double length, double width) {
    return shell().level (height, length, width, 1.0, 1.0).lastKind();
  };
  expectLimits ({{"height of a sill [m]",
                  0.1,
                  "floor",
                  "other",
                  [&] (double height) { return kindOfLevel (height, 0.5, 0.5); }},
                 {"height of a step [m]",
                  0.3,
                  "floor",
                  "table",
                  [&] (double height) { return kindOfLevel (height, 2.0, 1.0); }},
                 {"area of a step [m^2]",
                  1.0,
                  "other",
                  "floor",
                  [&] (double area) { return kindOfLevel (0.2, 1.0, area); }},
                 {"area of a slab [m^2]", 2.0, "other", "slab", [&] (double area) {
                    return kindOfLevel (1.5, 2.0, 0.5 * area);
                  }}});
}

TEST (KindLimits, OfTheLowestFloor)
{
  // The kind of a level, 1 m above the foot of an upright plane that is 1 m high.
  const auto kindAboveFoot = [] (double area_of_upright, double area) {
    Rectangles scene;
    scene.level (0.0, 10.0, 0.1 * area);
    scene.add ({0, 20, -1}, {area_of_upright, 0, 0}, {0, 0, 1});
    return scene.kinds().front();
  };
  expectLimits (
      {{"area of an upright that says how deep a scene is [m^2]",
        0.3,
        "floor",
        "slab",
        [&] (double area_of_upright) { return kindAboveFoot (area_of_upright, 12.0); }},
       {"area of a level that is ground [m^2]",
        50.0,
        "slab",
        "floor",
        [&] (double area) { return kindAboveFoot (1.0, area); }}});
}

TEST (KindLimits, OfCeilingsBelowAHigherOne)
{
  // The kind of a level that is below a ceiling at a height of 3.5 m.
  const auto kindBelowCeiling =
      [] (double below, double length, double width, const Vector3d& sensor) {
        Rectangles hall;
        hall.sensor = sensor;
        hall.level (0.0, 4_m, 3_m).level (3.5, 4_m, 3_m);
        return hall.level (3.5 - below, length, width).lastKind();
      };
  const Vector3d in_the_hall (2.0, 1.5, 1.2);
  expectLimits (
      {{"how far a beam is below the ceiling [m]",
        0.6,
        "ceiling",
        "other",
        [&] (double below) { return kindBelowCeiling (below, 1.0, 1.0, in_the_hall); }},
       {"area of a beam [m^2]",
        0.3,
        "other",
        "ceiling",
        [&] (double area) { return kindBelowCeiling (0.3, 1.0, area, in_the_hall); }},
       {"how far a plane seen from above is below the ceiling [m]",
        0.15,
        "ceiling",
        "other",
        [&] (double below) {
          return kindBelowCeiling (below, 1.0, 1.0, sensor_far_above);
        }}});
}

TEST (KindLimits, OfCeilingsWithoutAHigherOne)
{
  // The kind of a level above a floor.
  const auto kindAlone = [] (double height, double length, double width) {
    return floor4By3().level (height, length, width).lastKind();
  };
  expectLimits ({{"headroom [m]",
                  1.9,
                  "other",
                  "ceiling",
                  [&] (double height) { return kindAlone (height, 1.2, 1.0); }},
                 {"area of a ceiling that cupboards reach [m^2]",
                  1.0,
                  "other",
                  "ceiling",
                  [&] (double area) { return kindAlone (2.1, 1.0, area); }},
                 {"height of a ceiling above cupboards [m]",
                  2.3,
                  "other",
                  "ceiling",
                  [&] (double height) { return kindAlone (height, 0.5, 0.5); }},
                 {"area of a ceiling above cupboards [m^2]",
                  0.1,
                  "other",
                  "ceiling",
                  [&] (double area) { return kindAlone (2.6, 4.0 * area, 0.25); }}});
}

TEST (KindLimits, OfStories)
{
  // The kind of a board that ends 10 cm below a level at a height of 2.5 m: a wall if
  // the level makes a story. The floor is a square.
  const auto kindBelowLevel = [] (double edge_of_floor, double length, double width) {
    Rectangles room;
    room.level (0.0, edge_of_floor, edge_of_floor).level (2.5, length, width);
    return kindOfBoard (room, 1.0, 2.4);
  };
  // The kind of a level that has this share of the area of the floor below it.
  const auto kindAboveShare = [] (double share) {
    Rectangles house;
    house.sensor = sensor_far_above;
    return house.level (0.0, 4_m, 3_m).level (2.5, 4_m, 3.0 * share).lastKind();
  };
  // The kind of the lower side of a deck, whose upper side is this much higher.
  const auto kindOfLowerSide = [] (double thickness) {
    Rectangles house;
    house.sensor = sensor_far_above;
    house.level (0.0, 4_m, 3_m).level (2.5 + thickness, 4_m, 3_m);
    return house.level (2.5, 4_m, 3_m).lastKind();
  };
  expectLimits (
      {{"area of a level that makes a story [m^2]",
        1.0,
        "other",
        "wall",
        [&] (double area) { return kindBelowLevel (2.0, 1.0, area); }},
       {"the same as a share of the largest level",
        0.2,
        "other",
        "wall",
        [&] (double share) { return kindBelowLevel (4.0, 4.0, 4.0 * share); }},
       {"area of a ceiling as a share of the floor",
        1.0 / 3.0,
        "roof",
        "ceiling",
        kindAboveShare},
       {"thickness of a deck [m]", 0.8, "ceiling", "roof", kindOfLowerSide}});
}

TEST (KindLimits, OfWalls)
{
  // The kind of an upright plane on a floor, without a ceiling.
  const auto kindOfUpright = [] (double width, double height) {
    return floor4By3().add ({0, 3, 0}, {width, 0, 0}, {0, 0, height}).lastKind();
  };
  expectLimits (
      {{"height of a wall [m]",
        1.3,
        "other",
        "wall",
        [&] (double height) { return kindOfUpright (2.0, height); }},
       {"width of a wall [m]",
        1.0,
        "other",
        "wall",
        [&] (double width) { return kindOfUpright (width, 1.6); }},
       {"gap between a wall and the ceiling [m]",
        0.3,
        "wall",
        "other",
        [] (double gap) { return kindOfBoard (shell(), 1.0, 2.5 - gap); }},
       {"height of a wall at the ceiling [m]",
        0.5,
        "other",
        "wall",
        [] (double height) { return kindOfBoard (shell(), 2.5 - height, 2.5); }}});
}

TEST (KindLimits, OfFrontsBeforeWalls)
{
  // The kind of a front 1.8 m high, this far before a wall and turned about the
  // vertical. Furniture is turned by at most acos (0.9) = 25.8 degrees relative to its
  // wall.
  const auto kindOfFront = [] (double distance, double degrees) {
    const double angle = degrees * M_PI / 180.0;
    const Vector3d along (std::cos (angle), std::sin (angle), 0.0);
    return shell().add ({1, distance, 0}, 1.2 * along, {0, 0, 1.8}).lastKind();
  };
  expectLimits (
      {{"depth of a relief [m]",
        0.1,
        "wall",
        "other",
        [&] (double depth) { return kindOfFront (depth, 0.0); }},
       {"depth of furniture [m]",
        1.0,
        "other",
        "wall",
        [&] (double depth) { return kindOfFront (depth, 0.0); }},
       {"turn of furniture [degrees]", 25.8, "other", "wall", [&] (double degrees) {
          return kindOfFront (0.3, degrees);
        }}});
}

TEST (KindLimits, OfPartsOfWalls)
{
  // The kind of a small plane this far behind a wall and turned about the vertical.
  // Parts of a wall are turned by at most acos (0.985) = 9.94 degrees relative to it.
  const auto kindOfPart = [] (double behind, double degrees) {
    const double angle = degrees * M_PI / 180.0;
    const Vector3d along (0.3 * std::sin (angle), 0.3 * std::cos (angle), 0.0);
    return shell()
        .add (Vector3d (4.0 + behind, 1, 0.4) - 0.5 * along, along, {0, 0, 0.3})
        .lastKind();
  };
  expectLimits ({{"distance of a part from its wall [m]",
                  0.1,
                  "wall",
                  "other",
                  [&] (double distance) { return kindOfPart (distance, 0.0); }},
                 {"turn of a part from its wall [degrees]",
                  9.94,
                  "wall",
                  "other",
                  [&] (double degrees) { return kindOfPart (0.0, degrees); }}});
}

TEST (KindLimits, OfRamps)
{
  // The kind of a slope in a room. Its lower end is at this height.
  const auto kindOfRamp =
      [] (double length, double degrees, double width, double height) {
        return shell()
            .add ({1, 1, height}, risingAlongX (length, degrees), {0, width, 0})
            .lastKind();
      };
  // The kind of a slope 16 m long.
  const auto kindOfLongRamp = [] (double degrees) {
    Rectangles hall;
    hall.level (0.0, 30_m, 5_m);
    return hall.add ({1, 1, 0}, risingAlongX (16.0, degrees), {0, 1.2, 0}).lastKind();
  };
  expectLimits (
      {{"least slope of a ramp [degrees]", 2.5, "slab", "ramp", kindOfLongRamp},
       {"largest slope of a ramp [degrees]",
        35.0,
        "ramp",
        "other",
        [&] (double degrees) { return kindOfRamp (1.0, degrees, 1.2, 0.0); }},
       {"area of a ramp, 1 m long [m^2]",
        0.5,
        "other",
        "ramp",
        [&] (double area) { return kindOfRamp (1.0, 15.0, area, 0.0); }},
       {"rise of a ramp [m]",
        0.15,
        "other",
        "ramp",
        [&] (double rise) {
          constexpr double degrees = 15.0;
          const double length = rise / std::sin (degrees * 1_deg);
          return kindOfRamp (length, degrees, 1.2, 0.0);
        }},
       {"height at which a ramp begins [m]", 0.2, "ramp", "other", [&] (double height) {
          return kindOfRamp (1.0, 15.0, 1.2, height);
        }}});
}

TEST (KindLimits, OfRoofs)
{
  // The kind of a slope 4 m wide, with its middle at this height. It rises by 3 m on 4
  // m: its depth seen from above is 0.8 times its length.
  const auto kindOfSlope = [] (double middle, double area) {
    const double depth = 0.8 * area / 4.0;
    return survey()
        .add ({0, 0, middle - 0.375 * depth}, {4, 0, 0}, {0, depth, 0.75 * depth})
        .lastKind();
  };
  // The kind of a slope whose points have this rms distance to their plane.
  const auto kindOfRough = [] (double rms, std::optional<double> noise) {
    Rectangles scene = survey();
    scene.add ({0, 0, 5}, {8, 0, 0}, {0, 4, 3});
    PlaneSegment& roof = scene.planes.back();
    roof.moments = Moments::of (
        1000.0, roof.centroid, rms * rms * roof.normal * roof.normal.transpose());
    roof.noise = noise;
    return scene.lastKind();
  };
  expectLimits ({{"area of a roof [m^2]",
                  2.0,
                  "other",
                  "roof",
                  [&] (double area) { return kindOfSlope (5.0, area); }},
                 {"height of the middle of a roof [m]",
                  1.9,
                  "other",
                  "roof",
                  [&] (double height) { return kindOfSlope (height, 8.0); }},
                 {"rms of a roof of unknown noise [m]",
                  0.35,
                  "roof",
                  "other",
                  [&] (double rms) { return kindOfRough (rms, {}); }},
                 {"rms of a roof with a noise of 5 cm, at most three noises [m]",
                  0.15,
                  "roof",
                  "other",
                  [&] (double rms) { return kindOfRough (rms, 0.05); }}});
}

TEST (KindLimits, OfLevelRoofs)
{
  // The kind of a level 0.3 m above a ceiling. A wall begins and ends at these heights
  // above the level.
  const auto kindOfUpperLevel = [] (double wall_begin, double wall_end) {
    Rectangles house;
    house.sensor = sensor_far_above;
    house.level (0.0, 6_m, 5_m).level (2.5, 6_m, 5_m);
    house.add ({0, 0, 2.8 + wall_begin}, {6, 0, 0}, {0, 0, wall_end - wall_begin});
    return house.level (2.8, 6_m, 5_m).lastKind();
  };
  expectLimits (
      {{"gap between a level roof and a wall above [m]",
        0.3,
        "floor",
        "roof",
        [&] (double gap) { return kindOfUpperLevel (gap, 3.0); }},
       {"height of a wall that rises from a level roof [m]",
        1.9,
        "roof",
        "floor",
        [&] (double wall_height) { return kindOfUpperLevel (0.0, wall_height); }}});
}

TEST (KindLimits, OfFurnitureBeforeWalls)
{
  // The kind of the front of a cupboard, 1.8 m high and 1.5 m wide, before a wall.
  const auto kindOfFront = [] (double wall_height, double wall_width) {
    Rectangles room = floor4By3();
    room.add ({0, 3, 0}, {wall_width, 0, 0}, {0, 0, wall_height});
    return room.add ({0, 2.6, 0}, {1.5, 0, 0}, {0, 0, 1.8}).lastKind();
  };
  expectLimits (
      {{"height of the wall behind furniture [m]",
        1.8,
        "wall",
        "other",
        [&] (double wall_height) { return kindOfFront (wall_height, 4.0); }},
       {"area of the wall behind furniture [m^2]",
        2.7,
        "wall",
        "other",
        [&] (double wall_area) { return kindOfFront (2.4, wall_area / 2.4); }}});
}

TEST (KindLimits, OfASensorThatLeans)
{
  // A ground of 12 m^2 that slopes, 2 m below the sensor, and after it a level plane
  // with this middle and area.
  const auto groundBeside = [] (double degrees, const Vector3d& middle, double area) {
    Rectangles room;
    room.sensor = {0, 0, 0};
    const Eigen::AngleAxisd lean (degrees * M_PI / 180.0, Vector3d::UnitX());
    const Vector3d depth = lean * Vector3d (0, 3, 0);
    room.add (Vector3d (1, 0, -2) - 0.5 * depth, {4, 0, 0}, depth);
    const Vector3d side (0.0, area / 4.0, 0.0);
    return room.add (middle - 0.5 * side, {4, 0, 0}, side);
  };
  // The kind of this ground beside a level plane of a share of its area.
  const auto kindBesideLevel = [&] (double share) {
    return groundBeside (10.0, {-5, 0, -2}, 12.0 * share).kindsFromSensor().front();
  };
  // A road that slopes: the kind of its part 10 m to 14 m uphill of a part below the
  // sensor.
  const auto kindUpTheSlope = [] (double degrees) {
    Rectangles road;
    road.sensor = {0, 0, 0};
    const Eigen::AngleAxisd lean (degrees * M_PI / 180.0, Vector3d::UnitX());
    for (const double begin : {-2.0, 10.0})
      road.add (Vector3d (1, 0, -2) + lean * Vector3d (0, begin, 0),
                {2, 0, 0},
                lean * Vector3d (0, 4, 0));
    return road.kindsFromSensor().back();
  };
  expectLimits (
      {{"area of a level beside the ground, as a share of it",
        0.2,
        "floor",
        "other",
        kindBesideLevel},
       {"least slope of the ground [degrees]", 3.0, "slab", "floor", kindUpTheSlope}});
}

TEST (KindLimits, OfTheGroundOfASensorThatLeans)
{
  // The kind of a ground 1 m wide that slopes by an angle, with a sensor at this height
  // above its lower end.
  const auto kindOfGround = [] (double degrees, double area, double height) {
    Rectangles room;
    room.sensor = {0.5, 0.5, height};
    const Eigen::AngleAxisd lean (degrees * M_PI / 180.0, Vector3d::UnitX());
    room.add ({0, 0, 0}, {1, 0, 0}, lean * Vector3d (0, area, 0));
    return room.kindsFromSensor().back();
  };
  expectLimits ({{"largest slope of the ground [degrees]",
                  12.0,
                  "floor",
                  "ramp",
                  [&] (double degrees) { return kindOfGround (degrees, 12.0, 2.0); }},
                 {"area of the ground [m^2]", 4.0, "ramp", "floor", [&] (double area) {
                    return kindOfGround (10.0, area, 2.0);
                  }}});
}

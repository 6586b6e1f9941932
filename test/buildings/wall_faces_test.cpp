// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "buildings/wall_faces.h"
#include "scene.h"

#include <algorithm>

using namespace pcl_ops::internal::buildings;

namespace {

constexpr double height_of_cut = 1.2; // [m]

/** \brief The face of a wall along the x axis whose front is towards +y.
 * \param[in] points of the wall
 * \param[in] plane index of its plane */
WallFace
faceAlongX (const PlanPoints& points, std::size_t plane)
{
  return faceOf ({0, 1, 0}, points, plane, height_of_cut);
}

/** \brief Adds a grid of points, 1 cm apart along x and 5 cm upwards, on an upright
 * rectangle, 2 m high, at this y and from one x to another. */
void
addUpright (double y, double from, double to, PlanPoints& points)
{
  for (double x = from; x < to + 1_mm; x += 1_cm)
    for (double z = 0.025; z < 2.0; z += 5_cm)
      points.emplace_back (x, y, z);
}

/** \brief Indices of the planes of a face, ascending. */
std::vector<std::size_t>
planesOf (const WallFace& face)
{
  std::vector<std::size_t> planes;
  for (const auto& [plane, extent] : face.extent_of_plane)
    planes.push_back (plane);
  return planes;
}

/** \brief Points of a wall along x with a gap from x = 1 m to 2 m.
 * \param[in] lintel height from which on the wall reaches over the gap [m] */
PlanPoints
wallWithGap (double lintel)
{
  PlanPoints points;
  addUpright (0.0, 0.0, 1_m, points);
  addUpright (0.0, 2_m, 4_m, points);
  for (double x = 1_m; x < 2.0; x += 1_cm)
    for (double z = lintel; z < 2.5; z += 5_cm)
      points.emplace_back (x, 0.0, z);
  return points;
}

} // namespace

TEST (WallFaces, KeepTheirEndsThoughALeafIsSeenBeyondTheGap)
{
  PlanPoints points;
  addUpright (0.0, 0.0, 1_m, points);
  addUpright (0.0, 2_m, 4_m, points);
  const WallFace wall = faceAlongX (points, 0);
  // Set back by 10 cm; at both ends a centimeter longer than the gap.
  PlanPoints of_leaf;
  addUpright (-0.1, 0.99, 2.01, of_leaf);
  const WallFace leaf = faceAlongX (of_leaf, 1);
  const std::vector<WallFace> walls = withoutRecesses ({wall, leaf}, {});
  ASSERT_EQ (walls.size(), 1u) << "the leaf is no wall";
  ASSERT_EQ (walls[0].at_cut.size(), 2u);
  // The intervals of the wall at the cut do not change.
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR (walls[0].at_cut[i].from, wall.at_cut[i].from, 1_mm);
    EXPECT_NEAR (walls[0].at_cut[i].to, wall.at_cut[i].to, 1_mm);
  }
}

TEST (WallFaces, HaveAGapWhereALeafIsSeenThoughFurnitureTouchesThem)
{
  PlanPoints points;
  addUpright (0.0, 0.0, 1_m, points);
  addUpright (0.0, 2_m, 4_m, points);
  for (double x = 1_m; x < 1.4; x += 1_cm) // a counter at the height of the cut
    points.emplace_back (x, 0.0, height_of_cut);
  PlanPoints of_leaf;
  addUpright (-0.1, 1_m, 2_m, of_leaf);
  const std::vector<WallFace> walls =
      withoutRecesses ({faceAlongX (points, 0), faceAlongX (of_leaf, 1)}, {});
  ASSERT_EQ (walls.size(), 1u);
  double length_at_cut = 0.0;
  for (const auto& [from, to] : walls[0].at_cut)
    length_at_cut += to - from;
  EXPECT_NEAR (length_at_cut, 3_m, 5_cm) << "the meter of the gap is left out";
}

TEST (WallFaces, OfFurnitureStandBeforeAWallThatIsSeenAboveThem)
{
  // How many of two faces are kept: that of a wall with points from a lowest to a
  // highest height, and that of a front 2 m high at a distance before it. side is 1 if
  // both face the same way, and -1 if they face in opposite directions.
  const auto facesKept =
      [] (double distance, double highest, double side, double lowest = 0.0) {
        PlanPoints of_front;
        addUpright (distance, 1_m, 2_m, of_front);
        PlanPoints of_wall;
        for (double x = 0.0; x < 4.0; x += 5_cm)
          for (double z = lowest + 0.025; z < highest; z += 5_cm)
            of_wall.emplace_back (x, 0.0, z);
        return withoutFurniture ({faceAlongX (of_wall, 0),
                                  faceOf ({0, side, 0}, of_front, 1, height_of_cut)})
            .size();
      };
  EXPECT_EQ (facesKept (0.4, 2.5, 1.0), 1u);
  EXPECT_EQ (facesKept (0.4, 2.0, 1.0), 2u) << "the wall is as low as the front";
  EXPECT_EQ (facesKept (1.5, 2.5, 1.0), 2u) << "no furniture is so deep";
  EXPECT_EQ (facesKept (0.4, 2.5, -1.0), 2u) << "the side of another room";
  EXPECT_EQ (facesKept (0.4, 5.0, 1.0, 2.8), 2u) << "a wall of the next story";
}

TEST (WallFaces, OfFurnitureStandBeforeAWallByTheirMiddleThoughOneEndIsSeenBetter)
{
  PlanPoints of_wall, of_front;
  for (double x = 0.0; x < 4.0; x += 5_cm)
    for (double z = 0.025; z < 2.5; z += 5_cm)
      of_wall.emplace_back (x, 0.0, z);
  // A cupboard 6 cm before the wall at one end, 18 cm at the other. Two thirds of its
  // points are on the last 10 cm.
  for (double x = 1_m; x < 2.0; x += 1_cm) {
    const double step = x < 1.9 ? 5_cm : 0.0025;
    for (double z = 0.0; z < 2.0; z += step)
      of_front.emplace_back (x, 6_cm + 0.12 * (x - 1_m), z);
  }
  EXPECT_EQ (withoutFurniture ({faceAlongX (of_wall, 0),
                                faceOf ({-0.12, 1, 0}, of_front, 1, height_of_cut)})
                 .size(),
             1u)
      << "the middle of the front is 12 cm before the wall";
}

TEST (WallFaces, OnOneLineAreOneOfAllTheirPlanes)
{
  PlanPoints left, right, across;
  addUpright (0.0, 0.0, 2_m, left);
  addUpright (0.0, 2.5, 4_m, right);
  addUpright (1_m, 0.0, 2_m, across);
  const std::vector<WallFace> joined =
      joinFaces ({faceAlongX (left, 7), faceAlongX (across, 3), faceAlongX (right, 5)});
  ASSERT_EQ (joined.size(), 2u);
  EXPECT_EQ (planesOf (joined[0]), (std::vector<std::size_t>{3}));
  EXPECT_EQ (planesOf (joined[1]), (std::vector<std::size_t>{5, 7}));
}

TEST (WallFaces, OnOneLineAreSeenAndCutWhereTheirPlanesAre)
{
  PlanPoints left, right;
  addUpright (0.0, 0.0, 2_m, left);
  addUpright (0.0, 2.5, 4_m, right);
  const std::vector<WallFace> joined =
      joinFaces ({faceAlongX (left, 7), faceAlongX (right, 5)});
  ASSERT_EQ (joined.size(), 1u);
  const auto expectRuns = [&] (const Interval& interval, double from, double to) {
    EXPECT_NEAR (joined[0].line.at (interval.from).x(), from, 2_cm);
    EXPECT_NEAR (joined[0].line.at (interval.to).x(), to, 2_cm);
  };
  for (const Intervals& intervals : {joined[0].seen, joined[0].at_cut}) {
    ASSERT_EQ (intervals.size(), 2u);
    expectRuns (intervals[0], 0.0, 2_m);
    expectRuns (intervals[1], 2.5, 4_m);
  }
  expectRuns (joined[0].extent_of_plane.at (7), 0.0, 2_m);
  expectRuns (joined[0].extent_of_plane.at (5), 2.5, 4_m);
}

TEST (WallFaces, OnOneLineEndRoomsIfAllOfThemDo)
{
  PlanPoints left, right;
  addUpright (0.0, 0.0, 2_m, left);
  addUpright (0.0, 2.5, 4_m, right);
  for (const bool right_ends_rooms : {false, true}) {
    std::vector<WallFace> faces = {faceAlongX (left, 7), faceAlongX (right, 5)};
    faces[0].ends_rooms = true;
    faces[1].ends_rooms = right_ends_rooms;
    EXPECT_EQ (joinFaces (faces).at (0).ends_rooms, right_ends_rooms);
  }
}

TEST (WallFaces, OnOneLineHaveTheLineOfTheLargestWhicheverPlaneIsFirst)
{
  PlanPoints large, small;
  addUpright (0.0, 0.0, 3_m, large);
  addUpright (1_cm, 3.1, 4_m, small);
  for (const std::size_t plane_of_large : {2, 8}) {
    const std::vector<WallFace> joined =
        joinFaces ({faceAlongX (small, 5), faceAlongX (large, plane_of_large)});
    ASSERT_EQ (joined.size(), 1u);
    EXPECT_NEAR (joined[0].line.distance ({0.0, 0.0}), 0.0, 1_mm);
  }
}

TEST (WallFaces, OnOneLineTakeAPartThatDriftSetBack)
{
  constexpr double no_lintel = 9_m;
  const PlanPoints points = wallWithGap (no_lintel);
  PlanPoints moved;
  addUpright (-3_cm, 1_m, 2_m, moved);
  const std::vector<WallFace> joined =
      joinFaces ({faceAlongX (points, 0), faceAlongX (moved, 1)});
  ASSERT_EQ (joined.size(), 1u);
  EXPECT_EQ (planesOf (joined[0]), (std::vector<std::size_t>{0, 1}));
}

TEST (WallFaces, OnOneLineAreApartWhereOneIsALeafThatTheOtherSurrounds)
{
  // The number of faces of a wall with a gap from x = 1 m to 2 m and of a leaf 3 cm
  // behind the gap, 2 m high. The wall reaches over the gap from a height on.
  const auto facesJoined = [] (double lintel) {
    const PlanPoints points = wallWithGap (lintel);
    PlanPoints of_leaf;
    addUpright (-3_cm, 1_m, 2_m, of_leaf);
    return joinFaces ({faceAlongX (points, 0), faceAlongX (of_leaf, 1)}).size();
  };
  constexpr double no_lintel = 9_m;
  EXPECT_EQ (facesJoined (2.05), 2u);
  EXPECT_EQ (facesJoined (no_lintel), 1u) << "a part of the wall that drift moved";
}

TEST (WallFaces, OnOneLineAreApartWhereOneIsALeafThoughTheLintelIsAFaceOfItsOwn)
{
  PlanPoints points, of_lintel, of_leaf;
  addUpright (0.0, 0.0, 1_m, points);
  addUpright (0.0, 2_m, 4_m, points);
  for (double x = 1_m; x < 2.0; x += 1_cm)
    for (double z = 2.05; z < 2.5; z += 5_cm)
      of_lintel.emplace_back (x, 0.0, z);
  addUpright (-3_cm, 1_m, 2_m, of_leaf);
  ASSERT_LT (of_lintel.size(), of_leaf.size()) << "the leaf comes first";
  const std::vector<WallFace> joined = joinFaces (
      {faceAlongX (points, 0), faceAlongX (of_leaf, 1), faceAlongX (of_lintel, 2)});
  ASSERT_EQ (joined.size(), 2u);
  EXPECT_EQ (planesOf (joined[0]), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ (planesOf (joined[1]), (std::vector<std::size_t>{1}));
}

TEST (WallFaces, OfNoPointsAreNone)
{
  PlanPoints points;
  addUpright (0.0, 0.0, 1_m, points);
  const std::vector<WallFace> joined =
      joinFaces ({faceAlongX ({}, 0), faceAlongX (points, 1)});
  ASSERT_EQ (joined.size(), 1u);
  EXPECT_EQ (planesOf (joined[0]), std::vector<std::size_t>{1});
}

TEST (WallFaces, AreCutWithin5CentimetersOfTheHeight)
{
  const auto isCut = [] (double highest) {
    PlanPoints points; // 1 cm apart; the highest ones are below the cut at 1.2 m
    for (double x = 0.0; x < 1.0; x += 1_cm)
      for (double z = highest; z > highest - 0.5; z -= 1_cm)
        points.emplace_back (x, 0.0, z);
    return !faceAlongX (points, 0).at_cut.empty();
  };
  EXPECT_TRUE (isCut (1.16));
  EXPECT_FALSE (isCut (1.14));
}

TEST (WallFaces, AreCutWithinThreeSpacingsWherePointsAreFarApart)
{
  const auto isCut = [] (double highest) {
    PlanPoints points; // 10 cm apart; the highest ones are below the cut at 1.2 m
    for (double x = 0.0; x < 3.0; x += 10_cm)
      for (double z = highest; z > highest - 2.0; z -= 10_cm)
        points.emplace_back (x, 0.0, z);
    return !faceAlongX (points, 0).at_cut.empty();
  };
  EXPECT_TRUE (isCut (0.95));
  EXPECT_FALSE (isCut (0.8));
}

TEST (WallFaces, HaveNoGapsUpTo25CentimetersOrSixSpacings)
{
  // The number of parts of a wall that has a gap without points.
  const auto partsSeen = [] (double spacing, double gap) {
    PlanPoints points;
    for (double x = 0.0; x < 4.0; x += spacing)
      for (double z = 0.0; z < 2.5; z += spacing)
        if (x <= 2.0 || x >= 2.0 + gap)
          points.emplace_back (x, 0.0, z);
    return faceAlongX (points, 0).seen.size();
  };
  EXPECT_EQ (partsSeen (1_cm, 22_cm), 1u);
  EXPECT_EQ (partsSeen (1_cm, 28_cm), 2u);
  EXPECT_EQ (partsSeen (10_cm, 45_cm), 1u);
  EXPECT_EQ (partsSeen (10_cm, 85_cm), 2u);
}

TEST (WallFaces, AreLeavesBetweenTheEndsOfTheirWall)
{
  // The number of walls among one from x = 0 to 4 m, of which only a lintel is over the
  // first and the last meter, and a face 10 cm behind it.
  const auto wallsWithLeaf = [] (double from, double to) {
    PlanPoints points, of_leaf;
    addUpright (0.0, 1_m, 3_m, points);
    for (double x = 0.0; x < 4.0; x += 1_cm)
      for (double z = 2.05; z < 2.5; z += 5_cm)
        points.emplace_back (x, 0.0, z);
    addUpright (-0.1, from, to, of_leaf);
    return withoutRecesses ({faceAlongX (points, 0), faceAlongX (of_leaf, 1)}, {})
        .size();
  };
  EXPECT_EQ (wallsWithLeaf (3_m, 4_m), 1u);
  EXPECT_EQ (wallsWithLeaf (3.5, 4.5), 2u) << "ends beyond the wall";
  EXPECT_EQ (wallsWithLeaf (0.0, 1_m), 1u);
  EXPECT_EQ (wallsWithLeaf (-0.5, 0.5), 2u) << "begins before the wall";
}

TEST (WallFaces, AreTheOtherSideOfAWallThatCoversMostOfThem)
{
  // The number of walls among one that has a gap from x to 2 m, and a face behind it
  // from x = 1 m to 2 m.
  const auto wallsWithGapFrom = [] (double x) {
    PlanPoints points, behind;
    addUpright (0.0, 0.0, x, points);
    addUpright (0.0, 2_m, 4_m, points);
    addUpright (-0.1, 1_m, 2_m, behind);
    return withoutRecesses ({faceAlongX (points, 0), faceAlongX (behind, 1)}, {})
        .size();
  };
  EXPECT_EQ (wallsWithGapFrom (1.4), 1u);
  EXPECT_EQ (wallsWithGapFrom (1.8), 2u);
}

TEST (WallFaces, AreLeavesThoughTheFrameCoversTheirRim)
{
  // A window pane 28 cm wide, and a frame in the front of the wall 9 cm wide at both of
  // its sides.
  PlanPoints points, of_pane;
  addUpright (0.0, 0.15, 1.09, points);
  addUpright (0.0, 1.21, 2.15, points);
  addUpright (-0.1, 1.01, 1.29, of_pane);
  EXPECT_EQ (
      withoutRecesses ({faceAlongX (points, 0), faceAlongX (of_pane, 1)}, {}).size(),
      1u);
}

TEST (WallFaces, AreLeavesThoughTheyAreOnly28CentimetersWideAndHigh)
{
  // A window pane in a gap of 40 cm, 10 cm behind the wall.
  PlanPoints points, of_pane;
  addUpright (0.0, 0.0, 1.8, points);
  addUpright (0.0, 2.2, 4_m, points);
  for (double x = 1.86; x < 2.145; x += 1_cm)
    for (double z = 1.06; z < 1.345; z += 1_cm)
      of_pane.emplace_back (x, -0.1, z);
  EXPECT_EQ (
      withoutRecesses ({faceAlongX (points, 0), faceAlongX (of_pane, 1)}, {}).size(),
      1u);
}

TEST (WallFaces, AreNoLeavesLessThan2CentimetersBehindOrMoreThan45)
{
  // The number of walls among a wall with a gap and a leaf this far behind the gap.
  const auto wallsWithLeaf = [] (double behind) {
    PlanPoints points;
    addUpright (0.0, 0.0, 1_m, points);
    addUpright (0.0, 2_m, 4_m, points);
    PlanPoints of_leaf;
    addUpright (-behind, 1_m, 2_m, of_leaf);
    return withoutRecesses ({faceAlongX (points, 0), faceAlongX (of_leaf, 1)}, {})
        .size();
  };
  EXPECT_EQ (wallsWithLeaf (15_mm), 2u);
  EXPECT_EQ (wallsWithLeaf (25_mm), 1u);
  EXPECT_EQ (wallsWithLeaf (43_cm), 1u);
  EXPECT_EQ (wallsWithLeaf (47_cm), 2u);
}

TEST (WallFaces, AreLeavesByTheirMiddleThoughOneEndIsSeenBetter)
{
  PlanPoints points, of_leaf;
  addUpright (0.0, 0.0, 1_m, points);
  addUpright (0.0, 2_m, 6_m, points);
  // A leaf that is ajar: at x = 1 m it is in the front of the wall, at 2 m 6 cm behind
  // it. Two thirds of its points are on the last 10 cm.
  for (double x = 1_m; x < 2.0; x += 1_cm) {
    const double step = x < 1.9 ? 5_cm : 0.0025;
    for (double z = 0.0; z < 2.0; z += step)
      of_leaf.emplace_back (x, -0.06 * (x - 1_m), z);
  }
  const std::vector<WallFace> walls = withoutRecesses (
      {faceAlongX (points, 0), faceOf ({0.06, 1, 0}, of_leaf, 1, height_of_cut)}, {});
  EXPECT_EQ (walls.size(), 1u) << "the middle of the leaf is 3 cm behind the wall";
}

TEST (WallFaces, AreNoLeavesIfWallsThatFaceThemStandAtBothEndsOfTheGap)
{
  // The number of faces along x among a wall with a gap from x = 1 m to 2 m, a face
  // 20 cm behind it, and walls 2 m long across the ends of the gap. The wall reaches
  // over the gap from a height on.
  const auto facesAlongX = [] (bool has_left, bool has_right, double lintel) {
    const PlanPoints points = wallWithGap (lintel);
    PlanPoints behind, left, right;
    addUpright (-0.2, 1_m, 2_m, behind);
    for (double y = -0.2; y < 1.8; y += 1_cm)
      for (double z = 0.025; z < 2.0; z += 5_cm) {
        left.emplace_back (1.0, y, z);
        right.emplace_back (2.0, y, z);
      }
    std::vector<WallFace> faces = {faceAlongX (points, 0), faceAlongX (behind, 1)};
    if (has_left)
      faces.push_back (faceOf ({1, 0, 0}, left, 2, height_of_cut));
    if (has_right)
      faces.push_back (faceOf ({-1, 0, 0}, right, 3, height_of_cut));
    const std::vector<WallFace> walls = withoutRecesses (faces, {});
    return std::count_if (walls.begin(), walls.end(), [] (const WallFace& face) {
      return face.line.along.x() > 0.9;
    });
  };
  constexpr double no_lintel = 9_m;
  EXPECT_EQ (facesAlongX (true, true, no_lintel), 2) << "the end of another room";
  EXPECT_EQ (facesAlongX (true, false, no_lintel), 1) << "a door beside a corner";
  EXPECT_EQ (facesAlongX (true, true, 2.05), 1) << "a door at the end of a corridor";
}

TEST (WallFaces, AreLeavesIfAWallAtAnAngleMeetsTheirLineFarFromTheirEnd)
{
  // The number of faces along x among a wall with a gap from x = 1 m to 2 m, a face
  // 20 cm behind it, a wall across its right end, and one at 45 degrees to its left
  // that crosses its line at a distance from its left end.
  const auto facesAlongX = [] (double distance) {
    PlanPoints behind, left, right;
    addUpright (-0.2, 1_m, 2_m, behind);
    for (double step = 0.0; step < 2.0; step += 1_cm)
      for (double z = 0.025; z < 2.0; z += 5_cm) {
        left.emplace_back (1.0 - distance - step, -0.2 + step, z);
        right.emplace_back (2.0, -0.2 + step, z);
      }
    constexpr double no_lintel = 9_m;
    const std::vector<WallFace> walls =
        withoutRecesses ({faceAlongX (wallWithGap (no_lintel), 0),
                          faceAlongX (behind, 1),
                          faceOf ({1, 1, 0}, left, 2, height_of_cut),
                          faceOf ({-1, 0, 0}, right, 3, height_of_cut)},
                         {});
    return std::count_if (walls.begin(), walls.end(), [] (const WallFace& face) {
      return face.line.along.x() > 0.9;
    });
  };
  EXPECT_EQ (facesAlongX (10_cm), 2) << "the end of another room";
  EXPECT_EQ (facesAlongX (40_cm), 1) << "25 cm at most are closed";
}

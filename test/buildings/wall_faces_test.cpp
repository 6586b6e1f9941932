// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "buildings/wall_faces.h"
#include "scene.h"

using namespace pcl_ops::internal::buildings;

namespace {

/** \brief Adds a grid of an upright plane at some y. */
void
addUpright (double y, double from, double to, PlanPoints& points)
{
  for (double x = from; x < to + 1_mm; x += 1_cm)
    for (double z = 0.025; z < 2.0; z += 5_cm)
      points.emplace_back (x, y, z);
}

} // namespace

TEST (WallFaces, KeepTheirEndsThoughALeafIsSeenBeyondTheGap)
{
  PlanPoints points;
  addUpright (0.0, 0.0, 1_m, points);
  addUpright (0.0, 2_m, 4_m, points);
  const WallFace wall = faceOf ({0, 1, 0}, points, 0, 1.2);
  PlanPoints of_leaf; // set back by 10 cm, and a centimeter wider than the gap
  addUpright (-0.1, 0.99, 2.01, of_leaf);
  const WallFace leaf = faceOf ({0, 1, 0}, of_leaf, 1, 1.2);
  const std::vector<WallFace> walls = withoutRecesses ({wall, leaf}, {});
  ASSERT_EQ (walls.size(), 1u) << "the leaf is none";
  ASSERT_EQ (walls[0].cut.size(), 2u);
  // Parts of the cut along the line of the wall.
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR (walls[0].cut[i].from, wall.cut[i].from, 1_mm);
    EXPECT_NEAR (walls[0].cut[i].to, wall.cut[i].to, 1_mm);
  }
}

TEST (WallFaces, HaveAGapWhereALeafIsSeenThoughFurnitureTouchesThem)
{
  PlanPoints points;
  addUpright (0.0, 0.0, 1_m, points);
  addUpright (0.0, 2_m, 4_m, points);
  for (double x = 1_m; x < 1.4; x += 1_cm) // a counter at the height of the cut
    points.emplace_back (x, 0.0, 1.2);
  PlanPoints of_leaf;
  addUpright (-0.1, 1_m, 2_m, of_leaf);
  const std::vector<WallFace> walls = withoutRecesses (
      {faceOf ({0, 1, 0}, points, 0, 1.2), faceOf ({0, 1, 0}, of_leaf, 1, 1.2)}, {});
  ASSERT_EQ (walls.size(), 1u);
  double length = 0.0;
  for (const auto& [from, to] : walls[0].cut)
    length += to - from;
  EXPECT_NEAR (length, 3_m, 5_cm);
}

TEST (WallFaces, OfFurnitureStandBeforeAWallThatIsSeenAboveThem)
{
  const auto kept = [] (double distance, double top, double side, double low = 0.0) {
    PlanPoints of_front; // up to 2 m
    addUpright (distance, 1_m, 2_m, of_front);
    PlanPoints of_wall;
    for (double x = 0.0; x < 4.0; x += 5_cm)
      for (double z = low + 0.025; z < top; z += 5_cm)
        of_wall.emplace_back (x, 0.0, z);
    return withoutFurniture ({faceOf ({0, 1, 0}, of_wall, 0, 1.2),
                              faceOf ({0, side, 0}, of_front, 1, 1.2)})
        .size();
  };
  EXPECT_EQ (kept (0.4, 2.5, 1.0), 1u);
  EXPECT_EQ (kept (0.4, 2.0, 1.0), 2u) << "the wall is as low";
  EXPECT_EQ (kept (1.5, 2.5, 1.0), 2u) << "no furniture is so deep";
  EXPECT_EQ (kept (0.4, 2.5, -1.0), 2u) << "the side of another room";
  EXPECT_EQ (kept (0.4, 5.0, 1.0, 2.8), 2u) << "a wall of the next story";
}

TEST (WallFaces, OnOneLineAreOneOfAllTheirPlanes)
{
  PlanPoints left, right, across;
  addUpright (0.0, 0.0, 2_m, left);
  addUpright (0.0, 2.5, 4_m, right);
  addUpright (1_m, 0.0, 2_m, across);
  const std::vector<WallFace> joined = joinFaces ({faceOf ({0, 1, 0}, left, 7, 1.2),
                                                   faceOf ({0, 1, 0}, across, 3, 1.2),
                                                   faceOf ({0, 1, 0}, right, 5, 1.2)});
  ASSERT_EQ (joined.size(), 2u);
  EXPECT_EQ (joined[0].planes, (std::vector<std::size_t>{3}));
  EXPECT_EQ (joined[1].planes, (std::vector<std::size_t>{5, 7}));
}

TEST (WallFaces, OfNoPointsAreNone)
{
  PlanPoints points;
  addUpright (0.0, 0.0, 1_m, points);
  const std::vector<WallFace> joined =
      joinFaces ({faceOf ({0, 1, 0}, {}, 0, 1.2), faceOf ({0, 1, 0}, points, 1, 1.2)});
  ASSERT_EQ (joined.size(), 1u);
  EXPECT_EQ (joined[0].planes, std::vector<std::size_t>{1});
}

TEST (WallFaces, AreCutWithin5CentimetersOfTheHeight)
{
  const auto is_cut = [] (double top) {
    PlanPoints points; // 1 cm apart, up to somewhere below the cut
    for (double x = 0.0; x < 1.0; x += 1_cm)
      for (double z = top; z > top - 0.5; z -= 1_cm)
        points.emplace_back (x, 0.0, z);
    return !faceOf ({0, 1, 0}, points, 0, 1.2).cut.empty();
  };
  EXPECT_TRUE (is_cut (1.16));
  EXPECT_FALSE (is_cut (1.14));
}

TEST (WallFaces, AreCutWithinThreeSpacingsWherePointsAreFarApart)
{
  const auto is_cut = [] (double top) {
    PlanPoints points; // 10 cm apart, up to somewhere below the cut
    for (double x = 0.0; x < 3.0; x += 10_cm)
      for (double z = top; z > top - 2.0; z -= 10_cm)
        points.emplace_back (x, 0.0, z);
    return !faceOf ({0, 1, 0}, points, 0, 1.2).cut.empty();
  };
  EXPECT_TRUE (is_cut (0.95));
  EXPECT_FALSE (is_cut (0.8));
}

TEST (WallFaces, HaveNoGapsUpTo25CentimetersOrSixSpacings)
{
  const auto parts = [] (double spacing, double gap) {
    PlanPoints points;
    for (double x = 0.0; x < 4.0; x += spacing)
      for (double z = 0.0; z < 2.5; z += spacing)
        if (x <= 2.0 || x >= 2.0 + gap)
          points.emplace_back (x, 0.0, z);
    return faceOf ({0, 1, 0}, points, 0, 1.2).seen.size();
  };
  EXPECT_EQ (parts (1_cm, 22_cm), 1u);
  EXPECT_EQ (parts (1_cm, 28_cm), 2u);
  EXPECT_EQ (parts (10_cm, 45_cm), 1u);
  EXPECT_EQ (parts (10_cm, 85_cm), 2u);
}

TEST (WallFaces, AreNoLeavesLessThan2CentimetersBehindOrMoreThan45)
{
  const auto walls_with_leaf = [] (double behind) {
    PlanPoints points;
    addUpright (0.0, 0.0, 1_m, points);
    addUpright (0.0, 2_m, 4_m, points);
    PlanPoints of_leaf;
    addUpright (-behind, 1_m, 2_m, of_leaf);
    return withoutRecesses ({faceOf ({0, 1, 0}, points, 0, 1.2),
                             faceOf ({0, 1, 0}, of_leaf, 1, 1.2)},
                            {})
        .size();
  };
  EXPECT_EQ (walls_with_leaf (15_mm), 2u);
  EXPECT_EQ (walls_with_leaf (25_mm), 1u);
  EXPECT_EQ (walls_with_leaf (43_cm), 1u);
  EXPECT_EQ (walls_with_leaf (47_cm), 2u);
}

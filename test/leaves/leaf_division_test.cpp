// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"

using namespace pcl_ops::internal;

namespace {

/** \brief Points with the unevenness of their places, divided. */
struct Divided {
  Divided (const Coordinates& positions, const LeafSizes& sizes)
  : points (sortAlongCurve (positions, finest_cell, 1))
  , leaves (divideIntoLeaves (
        points, sizes, {points, scatterOfCells (points, 1), sizes.largest_level + 1}))
  {}

  /** \brief Mean number of points of the leaves that begin at such points. */
  template <typename IsSuch>
  double
  meanPoints (IsSuch&& isSuch) const
  {
    double number = 0.0, sum = 0.0;
    for (const Leaf& leaf : leaves)
      if (isSuch (points[leaf.begin])) {
        number += 1.0;
        sum += leaf.end - leaf.begin;
      }
    return sum / number;
  }

  CurvePoints points;
  std::vector<Leaf> leaves;
};

} // namespace

TEST (LeafDivision, MakesLeavesOfAGivenSize)
{
  const Divided divided (gridsOf ({ground}, 120), {level_of_10_cm, level_of_10_cm, 0});
  EXPECT_EQ (divided.leaves.size(), 400u);
  for (const Leaf& leaf : divided.leaves) {
    EXPECT_EQ (leaf.level, level_of_10_cm);
    EXPECT_EQ (leaf.end - leaf.begin, 36u);
  }
}

TEST (LeafDivision, DividesLeavesOfTooManyPointsDownToTheSmallest)
{
  // 576, 144, 36 and 9 points in leaves of 40, 20, 10 and 5 cm.
  const struct {
    double max_points;
    int level;
  } rows[] = {{1000, 4}, {150, 3}, {140, 2}, {37, 2}, {35, 1}, {1, 1}};
  for (const auto& row : rows)
    for (const Leaf& leaf :
         Divided (gridsOf ({ground}, 120), {4, 1, row.max_points}).leaves)
      ASSERT_EQ (leaf.level, row.level) << row.max_points;
}

TEST (LeafDivision, MakesSmallerLeavesWherePointsAreDenser)
{
  const Surface dense = {{4, 0, 0.05}, {0.5, 0, 0}, {0, 0.5, 0}};
  const Divided divided (gridsOf ({ground, dense}, 120), {4, 0, 40});
  for (const Leaf& leaf : divided.leaves)
    EXPECT_EQ (leaf.level, divided.points.x[leaf.begin] < 3.0f ? 2 : 0);
}

TEST (LeafDivision, PutsEachPointIntoOneLeafByAscendingCodes)
{
  const Divided divided (pointsInACube (3000, 2.0), {4, 0, 20});
  std::uint32_t end = 0;
  MortonCode code = 0;
  for (const Leaf& leaf : divided.leaves) {
    EXPECT_EQ (leaf.begin, end);
    EXPECT_GT (leaf.end, leaf.begin);
    EXPECT_GE (leaf.code, code);
    EXPECT_EQ (leaf.code,
               divided.points.code[leaf.begin] >> 3 * leaf.level << 3 * leaf.level);
    EXPECT_EQ (divided.points.code[leaf.end - 1] >> 3 * leaf.level,
               leaf.code >> 3 * leaf.level);
    end = leaf.end;
    code = leaf.code;
  }
  EXPECT_EQ (end, 3000u);
  EXPECT_TRUE (Divided (Coordinates(), {4, 0, 20}).leaves.empty());
}

TEST (LeafDivision, KeepsLargerLeavesWherePointsAreUneven)
{
  // Smaller leaves than of 20 cm would be facets of the bumps. Places of 80 cm begin
  // at 40 cm and 1.2 m.
  const Divided divided (checkerboard (2_cm, before (1.2)), {4, 1, 60});
  const auto isInUnevenPlace = [] (const auto& at) {
    return at.x() > 0.4 && at.x() < 1.2;
  };
  EXPECT_NEAR (divided.meanPoints (isInUnevenPlace), 144.0, 1.0);
  EXPECT_NEAR (divided.meanPoints (behind (1.2)), 36.0, 1.0);
  for (const Leaf& leaf : divided.leaves)
    if (isInUnevenPlace (divided.points[leaf.begin])) {
      EXPECT_NEAR (leaf.unevenness, 0.1, 0.01) << "2 cm of 20";
    }
}

TEST (Halving, MakesTheOccupiedEighthsOfALeaf)
{
  const Divided divided (gridsOf ({ground}, 120), {level_of_10_cm, level_of_10_cm, 0});
  for (const Leaf& leaf : divided.leaves) {
    std::vector<Leaf> halves;
    halveLeaf (divided.points, leaf, halves);
    ASSERT_EQ (halves.size(), 4u);
    EXPECT_EQ (halves.front().begin, leaf.begin);
    EXPECT_EQ (halves.back().end, leaf.end);
    for (const Leaf& half : halves) {
      EXPECT_EQ (half.end - half.begin, 9u);
      EXPECT_EQ (half.level, level_of_10_cm - 1);
      EXPECT_EQ (half.unevenness, leaf.unevenness);
    }
  }
}

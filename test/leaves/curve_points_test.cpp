// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"

using namespace pcl_ops::internal;

namespace {

Coordinates
backwards (const Coordinates& points)
{
  Coordinates reversed;
  for (std::size_t i = points.size(); i-- > 0;)
    reversed.add (points.x[i], points.y[i], points.z[i]);
  return reversed;
}

} // namespace

TEST (CurvePoints, AreInAnOrderThatDoesNotDependOnThatOfTheCloud)
{
  // 27 cells of some 37 points.
  const Coordinates cloud = pointsInACube (1000, 0.9);
  const CurvePoints points = sortAlongCurve (cloud, 0.3, 1);
  const CurvePoints others = sortAlongCurve (backwards (cloud), 0.3, 1);
  EXPECT_EQ (points.x, others.x);
  EXPECT_EQ (points.y, others.y);
  EXPECT_EQ (points.z, others.z);
  EXPECT_EQ (points.code, others.code);
}

TEST (CurvePoints, CountEqualPointsOnce)
{
  Coordinates cloud;
  for (const float z : {3.0f, 4.0f, 3.0f, 3.0f})
    cloud.add (1.0f, 2.0f, z);
  const CurvePoints points = sortAlongCurve (cloud, 0.1, 1);
  EXPECT_EQ (points.z, (std::vector<float>{3.0f, 4.0f}));
  EXPECT_EQ (points.code.size(), 2u);
  EXPECT_EQ (points.of_input, (Indices{0, 1, 0, 0}));
}

TEST (CurvePoints, KeepDifferentPointsOfACell)
{
  Coordinates cloud;
  for (const float x : {0.03f, 0.01f, 0.02f})
    cloud.add (x, 0.0f, 0.0f);
  const CurvePoints points = sortAlongCurve (cloud, 0.1, 1);
  EXPECT_EQ (points.x, (std::vector<float>{0.01f, 0.02f, 0.03f}));
  EXPECT_EQ (points.of_input, (Indices{2, 0, 1}));
}

TEST (CurvePoints, KnowWhichOfThemEachPointOfTheCloudIs)
{
  const Coordinates cloud = pointsInACube (1000, 1.0);
  const CurvePoints points = sortAlongCurve (cloud, 0.1, 1);
  ASSERT_EQ (points.of_input.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_EQ (points[points.of_input[i]], cloud[i]);
}

TEST (CurvePoints, HaveTheCodesOfTheirCellsInAscendingOrder)
{
  const CurvePoints points = sortAlongCurve (pointsInACube (1000, 1.0), 0.125, 1);
  EXPECT_TRUE (std::is_sorted (points.code.begin(), points.code.end()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto key = [] (float x) { return static_cast<int> (std::floor (8.0f * x)); };
    EXPECT_EQ (points.code[i],
               mortonCode (key (points.x[i]), key (points.y[i]), key (points.z[i])));
  }
}

TEST (EndOfCell, IsWhereTheNextCellOfThatSizeBegins)
{
  const std::vector<MortonCode> codes = {0, 1, 7, 8, 9, 64};
  EXPECT_EQ (endOfCell (codes, 0, 6, 0), 1u);
  EXPECT_EQ (endOfCell (codes, 0, 6, 1), 3u) << "eight codes share a cell";
  EXPECT_EQ (endOfCell (codes, 3, 6, 1), 5u);
  EXPECT_EQ (endOfCell (codes, 0, 6, 2), 5u) << "64 do";
  EXPECT_EQ (endOfCell (codes, 0, 6, 3), 6u);
  EXPECT_EQ (endOfCell (codes, 0, 2, 3), 2u) << "no farther than the end given";
}

TEST (EndOfCell, IsFoundInRunsOfAnyLength)
{
  for (std::uint32_t length = 1; length < 100; ++length) {
    std::vector<MortonCode> codes (length, 5);
    codes.resize (150, 9);
    EXPECT_EQ (endOfCell (codes, 0, 150, 0), length);
  }
}

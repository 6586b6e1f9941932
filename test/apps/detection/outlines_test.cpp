// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/advice.h>
#include <detection/plane_map.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>
#include <limits>

using namespace pcl_ops;
using namespace pcl_ops::apps;

namespace {

/** \brief A square around a point, counter-clockwise as seen from above. */
Ring
square (double half)
{
  return {{-half, -half, 1}, {half, -half, 1}, {half, half, 1}, {-half, half, 1}};
}

Ring
reversed (Ring ring)
{
  std::reverse (ring.begin(), ring.end());
  return ring;
}

} // namespace

TEST (Outlines, AreWrittenClosedWithTheirHoles)
{
  const Rings rings = {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}},
                       {{1, 1, 1}, {1, 2, 1}, {2, 1, 1}}};
  EXPECT_EQ (toWkt ({rings}, 0),
             "POLYGON Z ((0 0 1,4 0 1,0 4 1,0 0 1),(1 1 1,1 2 1,2 1 1,1 1 1))");
  EXPECT_EQ (toGeoJsonGeometry ({rings}, 0),
             R"({"type":"Polygon","coordinates":[[[0,0,1],[4,0,1],[0,4,1],[0,0,1]],)"
             R"([[1,1,1],[1,2,1],[2,1,1],[1,1,1]]]})");
}

TEST (Outlines, OfNoAreaAreEmpty)
{
  EXPECT_EQ (toWkt ({}, 3), "POLYGON Z EMPTY");
  EXPECT_EQ (toGeoJsonGeometry ({}, 3), "null");
}

TEST (Outlines, OfSeveralPartsAreMultiPolygons)
{
  const Rings one = {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}};
  const Rings other = {{{5, 5, 1}, {6, 5, 1}, {6, 6, 1}}};
  EXPECT_EQ (
      toWkt ({one, other}, 0),
      "MULTIPOLYGON Z (((0 0 1,4 0 1,0 4 1,0 0 1)),((5 5 1,6 5 1,6 6 1,5 5 1)))");
  EXPECT_EQ (toGeoJsonGeometry ({one, other}, 0),
             R"({"type":"MultiPolygon","coordinates":[[[[0,0,1],[4,0,1],[0,4,1],)"
             R"([0,0,1]]],[[[5,5,1],[6,5,1],[6,6,1],[5,5,1]]]]})");
}

TEST (Outlines, LoseCornersNearAStraightLine)
{
  const Ring jagged = {{0, 0.1, 0},
                       {2, 0, 0},
                       {4, 0.1, 0},
                       {6, 0, 0},
                       {6.1, 2, 0},
                       {6, 4, 0},
                       {3, 3.9, 0},
                       {0, 4, 0},
                       {0.1, 2, 0}};
  const Ring hole = {{1, 1, 0}, {1, 2, 0}, {1.1, 1, 0}};
  EXPECT_EQ (simplified ({jagged, hole}, 0.0), (Rings{jagged, hole}));
  const Rings simple = simplified ({jagged, hole}, 0.3);
  ASSERT_EQ (simple.size(), 1u) << "the hole has no area left";
  EXPECT_EQ (simple[0].size(), 4u);
  EXPECT_EQ (simplified ({hole}, 9.0), Rings{hole}) << "an outline stays one";
}

TEST (Outlines, GoRoundPlanesToTheLeftAndRoundHolesToTheRight)
{
  const Ring around = square (2), hole = reversed (square (1));
  const Rings expected = {around, hole};
  EXPECT_EQ (seenFromAbove ({around, hole}), expected);
  EXPECT_EQ (seenFromAbove ({reversed (around), reversed (hole)}), expected);
  const Rings wall = {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}}};
  EXPECT_EQ (seenFromAbove (wall), wall);
}

TEST (Outlines, HaveMillimetersFarFromZeroAndNoExponents)
{
  EXPECT_EQ (toWkt ({{{{5400000.1234, 1e-7, -1e-7}}}}, 3),
             "POLYGON Z ((5400000.123 0.000 0.000,5400000.123 0.000 0.000))");
}

TEST (Outlines, HaveDecimalsForTheNarrowestPlane)
{
  EXPECT_EQ (decimalsFor ({}), 3);
  EXPECT_EQ (decimalsFor ({5000.0, 0.0}), 3);
  EXPECT_EQ (decimalsFor ({5.0, 0.04}), 5);
  EXPECT_EQ (decimalsFor ({1e-30}), 12);
}

namespace {

/** \brief Whether of 100 readings and as many missing ones \p covered on a plane are
 * next to none. */
bool
isHardlyCoveredBy (int covered)
{
  constexpr int readings = 100;
  constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (int i = 0; i < readings; ++i) {
    cloud.push_back ({static_cast<float> (i), 0, 0});
    cloud.push_back ({not_a_number, not_a_number, not_a_number});
  }
  PlaneSegment plane;
  for (int i = 0; i < covered; ++i)
    plane.inliers.push_back (2 * i);
  return !adviceFor (OrientedPointSamplingParameters(), cloud, {plane}).empty();
}

} // namespace

TEST (Advice, IsGivenWherePlanesHaveLessThanATwentiethOfTheReadings)
{
  EXPECT_TRUE (isHardlyCoveredBy (0));
  EXPECT_TRUE (isHardlyCoveredBy (4));
  EXPECT_FALSE (isHardlyCoveredBy (5));
  EXPECT_EQ (adviceFor (OrientedPointSamplingParameters(), {}, {}),
             "every point is NaN or infinite");
}

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

TEST (Outlines, AreWrittenClosedWithTheirHolesAndParts)
{
  const Rings first = {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}},
                       {{1, 1, 1}, {1, 2, 1}, {2, 1, 1}}};
  const Rings other = {{{5, 5, 1}, {6, 5, 1}, {6, 6, 1}}};
  const std::string first_wkt = "((0 0 1,4 0 1,0 4 1,0 0 1),(1 1 1,1 2 1,2 1 1,1 1 1))";
  const std::string first_json =
      "[[[0,0,1],[4,0,1],[0,4,1],[0,0,1]],[[1,1,1],[1,2,1],[2,1,1],[1,1,1]]]";
  const struct {
    Polygons polygons;
    std::string wkt, json;
  } rows[] = {{{}, "POLYGON Z EMPTY", "null"},
              {{first},
               "POLYGON Z " + first_wkt,
               R"({"type":"Polygon","coordinates":)" + first_json + "}"},
              {{first, other},
               "MULTIPOLYGON Z (" + first_wkt + ",((5 5 1,6 5 1,6 6 1,5 5 1)))",
               R"({"type":"MultiPolygon","coordinates":[)" + first_json +
                   ",[[[5,5,1],[6,5,1],[6,6,1],[5,5,1]]]]}"}};
  for (const auto& row : rows) {
    EXPECT_EQ (toWkt (row.polygons, 0), row.wkt);
    EXPECT_EQ (toGeoJsonGeometry (row.polygons, 0), row.json);
  }
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

TEST (Advice, IsGivenWherePlanesHaveLessThanATwentiethOfTheReadings)
{
  constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
  const OrientedPointSamplingParameters ops;
  XyzCloud cloud;
  for (int i = 0; i < 100; ++i) {
    cloud.emplace_back (static_cast<float> (i), 0.0f, 0.0f);
    cloud.emplace_back (not_a_number, not_a_number, not_a_number);
  }
  for (const auto& [inliers, is_hardly_covered] :
       {std::pair (0, true), std::pair (4, true), std::pair (5, false)}) {
    PlaneSegment plane;
    plane.inliers.resize (inliers);
    EXPECT_NE (adviceFor (ops, cloud, {plane}).empty(), is_hardly_covered) << inliers;
  }
  EXPECT_EQ (adviceFor (ops, {}, {}), "every point is NaN or infinite");
}

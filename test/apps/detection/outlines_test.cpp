// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/outlines.h>

#include <algorithm>

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

PlaneExtent
withWidth (double width)
{
  PlaneExtent extent;
  extent.width = width;
  return extent;
}

} // namespace

TEST (Outlines, AreWrittenClosedWithTheirHoles)
{
  const Rings rings = {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}},
                       {{1, 1, 1}, {1, 2, 1}, {2, 1, 1}}};
  EXPECT_EQ (toWkt (rings, 0),
             "POLYGON Z ((0 0 1,4 0 1,0 4 1,0 0 1),(1 1 1,1 2 1,2 1 1,1 1 1))");
  EXPECT_EQ (toGeoJsonGeometry (rings, 0),
             R"({"type":"Polygon","coordinates":[[[0,0,1],[4,0,1],[0,4,1],[0,0,1]],)"
             R"([[1,1,1],[1,2,1],[2,1,1],[1,1,1]]]})");
}

TEST (Outlines, OfNoAreaAreEmpty)
{
  const Rings none = PlaneExtent{}.rings();
  EXPECT_EQ (toWkt (none, 3), "POLYGON Z EMPTY");
  EXPECT_EQ (toGeoJsonGeometry (none, 3), "null");
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
  EXPECT_EQ (toWkt ({{{5400000.1234, 1e-7, -1e-7}}}, 3),
             "POLYGON Z ((5400000.123 0.000 0.000,5400000.123 0.000 0.000))");
}

TEST (Outlines, HaveDecimalsForTheNarrowestPlane)
{
  EXPECT_EQ (decimalsFor ({}), 3);
  EXPECT_EQ (decimalsFor ({withWidth (5000.0), withWidth (0.0)}), 3);
  EXPECT_EQ (decimalsFor ({withWidth (5.0), withWidth (0.04)}), 5);
  EXPECT_EQ (decimalsFor ({withWidth (1e-30)}), 12);
}

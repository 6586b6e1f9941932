// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "extent/planar_hull.h"
#include "extent/rim.h"
#include "geometry/planar_area.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

/** \brief Whole numbers 0 .. last in both directions. */
PlanarPoints
lattice (int last)
{
  PlanarPoints points;
  for (int x = 0; x <= last; ++x)
    for (int y = 0; y <= last; ++y)
      points.emplace_back (x, y);
  return points;
}

const PlanarPoints unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

} // namespace

TEST (HullOfAll, HasTheCornersAlone)
{
  const PlanarPoints hull = hullOfAll (lattice (10));
  EXPECT_EQ (hull.size(), 4u);
  EXPECT_EQ (areaOf (hull), 100.0) << "above 0: counter-clockwise";
}

TEST (HullOfAll, IsNothingWherePointsSpanNoArea)
{
  EXPECT_TRUE (hullOfAll ({{0, 0}, {1, 1}, {2, 2}}).empty());
}

TEST (AreaOf, IsBelowZeroForClockwiseOutlines)
{
  EXPECT_EQ (areaOf (unit_square), 1.0);
  EXPECT_EQ (areaOf ({unit_square.rbegin(), unit_square.rend()}), -1.0);
}

TEST (Rim, TakesOffThePointsOnItsHull)
{
  Rim rim (lattice (4));
  EXPECT_EQ (areaOf (rim.hull()), 16.0);
  EXPECT_EQ (rim.takeOff (rim.hull(), 1), 16u) << "5 x 5 points with 3 x 3 inside";
  EXPECT_EQ (areaOf (rim.hull()), 4.0);
}

TEST (Rim, TakesOffAsManyAsWantedOrMore)
{
  Rim rim (lattice (10));
  EXPECT_GE (rim.takeOff (rim.hull(), 50), 50u) << "40 are on the hull";
}

TEST (Rim, KeepsTheHullOfManyPoints)
{
  EXPECT_EQ (areaOf (Rim (lattice (100)).hull()), 10000.0) << "most are set aside";
}

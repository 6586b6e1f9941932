// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/equal_points.h"
#include "grid_scene.h"

using namespace pcl_ops::internal;

namespace {

constexpr std::uint32_t lone_points = 1000;

/** \brief 1000 points without equals, and after them \p number points at (x, 0, 0). */
Coordinates
lonePointsAnd (std::size_t number, float x)
{
  Coordinates points = pointsInACube (lone_points, 4.0);
  for (std::size_t i = 0; i < number; ++i)
    points.add (x, 0.0f, 0.0f);
  return points;
}

} // namespace

TEST (FirstAtPlace, IsNotLookedForWhereAllPointsAreAlone)
{
  EXPECT_TRUE (firstAtPlace (lonePointsAnd (0, 0.0f), one_thread).empty());
  // Coordinates that are small whole numbers have most of their bits in common: a weak
  // hash would give many of these points the same one.
  constexpr int edge = 22; // of a cube of points 1 m apart [points]
  Coordinates lattice;
  for (int i = 0; i < edge * edge * edge; ++i)
    lattice.add (i % edge, i / edge % edge, i / edge / edge);
  EXPECT_TRUE (firstAtPlace (lattice, one_thread).empty());
}

TEST (FirstAtPlace, IsNoReadingWhereManyShareOnePlace)
{
  for (const float x : {0.0f, 17.5f}) {
    const FirstAtPlace first = firstAtPlace (lonePointsAnd (50, x), one_thread);
    ASSERT_EQ (first.size(), lone_points + 50);
    for (std::uint32_t i = 0; i < first.size(); ++i)
      EXPECT_EQ (first[i], i < lone_points ? i : no_reading);
  }
}

TEST (FirstAtPlace, IsThePointItselfWhereFewHaveEqualsBesideMissingReadings)
{
  constexpr std::uint32_t missing_readings = 50;
  constexpr std::uint32_t copies_begin = lone_points + missing_readings;
  constexpr std::uint32_t copies = 20;
  Coordinates points = lonePointsAnd (missing_readings, 0.0f);
  for (std::size_t i = 0; i < copies; ++i)
    points.add (points.x[i], points.y[i], points.z[i]);
  const FirstAtPlace first = firstAtPlace (points, one_thread);
  ASSERT_EQ (first.size(), copies_begin + copies);
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    const bool is_reading = i < lone_points || i >= copies_begin;
    EXPECT_EQ (first[i], is_reading ? i : no_reading);
  }
}

TEST (FirstAtPlace, IsTheFirstOfEqualPointsWhereAllHaveEquals)
{
  const Coordinates points = pointsInACube (1000, 4.0);
  Coordinates twice = points;
  for (std::size_t i = 0; i < points.size(); ++i)
    twice.add (points.x[i], points.y[i], points.z[i]);
  const FirstAtPlace first = firstAtPlace (twice, one_thread);
  ASSERT_EQ (first.size(), 2000u);
  for (std::uint32_t i = 0; i < 2000; ++i)
    EXPECT_EQ (first[i], i % 1000);
}

TEST (FirstAtPlace, TellsApartPlacesWithTheSameHash)
{
  // Some twenty pairs of places share a 32-bit hash: 400,000^2 / 2 / 2^32 = 19.
  constexpr std::uint32_t places = 400'000;
  Coordinates points = pointsInACube (places, 4.0);
  for (std::uint32_t i = 0; i < places; ++i)
    points.add (points.x[i], points.y[i], points.z[i]);
  const FirstAtPlace first = firstAtPlace (points, one_thread);
  ASSERT_EQ (first.size(), 2 * places);
  for (std::uint32_t i = 0; i < 2 * places; ++i)
    ASSERT_EQ (first[i], i % places) << i;
}

TEST (FirstAtPlace, TakesZeroAndMinusZeroForOnePlace)
{
  // At one place, 30 points are taken for missing readings, but 15 are too few.
  Coordinates points = lonePointsAnd (30, 0.0f);
  for (std::size_t i = lone_points; i < points.size(); i += 2)
    points.y[i] = -0.0f;
  const FirstAtPlace first = firstAtPlace (points, one_thread);
  ASSERT_EQ (first.size(), points.size());
  for (std::size_t i = lone_points; i < points.size(); ++i)
    EXPECT_EQ (first[i], no_reading) << i;
}

TEST (FirstAtPlace, IsNoReadingOfPointsThatAreNotFinite)
{
  Coordinates points = lonePointsAnd (50, 0.0f);
  points.x[7] = NAN;
  EXPECT_EQ (firstAtPlace (points, one_thread).at (7), no_reading);
}

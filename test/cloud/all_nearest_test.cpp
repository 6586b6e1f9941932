// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/all_nearest.h"
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace pcl_ops::internal;

namespace {

/** \brief Another point as a candidate for a nearest neighbor. */
struct OtherPoint {
  float squared_distance; // [m^2]
  std::uint32_t index;
};

/** \brief The nearest neighbors of each point by brute force: for point 0 the indices
 * of \p number others, by distance, then by index; after them those for point 1, and so
 * on. */
Indices
nearestOfEach (const Coordinates& points, std::size_t number)
{
  Indices nearest;
  for (std::uint32_t own = 0; own < points.size(); ++own) {
    std::vector<OtherPoint> others;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const float x = points.x[i] - points.x[own];
      const float y = points.y[i] - points.y[own];
      const float z = points.z[i] - points.z[own];
      if (i != own)
        others.push_back ({x * x + y * y + z * z, i});
    }
    std::sort (
        others.begin(), others.end(), [] (const OtherPoint& a, const OtherPoint& b) {
          return std::tie (a.squared_distance, a.index) <
                 std::tie (b.squared_distance, b.index);
        });
    for (std::size_t k = 0; k < number; ++k)
      nearest.push_back (others[k].index);
  }
  return nearest;
}

/** \brief Fails unless findAllNearest finds what brute force finds. */
void
expectAllNearest (const Coordinates& points, std::size_t number)
{
  const PointTree tree (points);
  EXPECT_EQ (findAllNearest (tree, number, one_thread), nearestOfEach (points, number));
}

/** \brief Adds points drawn uniformly in a cube whose coordinates go from \p lowest to
 * \p lowest + \p edge along each axis. */
void
addDrawn (std::size_t number, float lowest, float edge, Coordinates& points)
{
  RandomGenerator generator (seedOfTest());
  const auto draw = [&] {
    return lowest + edge * static_cast<float> (drawUnit (generator));
  };
  for (std::size_t i = 0; i < number; ++i) {
    const float x = draw();
    const float y = draw();
    points.add (x, y, draw());
  }
}

} // namespace

TEST (AllNearest, AreThoseOfBruteForce)
{
  Coordinates points;
  addDrawn (700, 0.0f, 1.0f, points);
  expectAllNearest (points, 20);
}

TEST (AllNearest, AreThoseOfLowestIndexAmongEquallyNearPoints)
{
  Coordinates grid;
  for (int x = 0; x < 15; ++x)
    for (int y = 0; y < 15; ++y)
      grid.add (static_cast<float> (x), static_cast<float> (y), 0.0f);
  expectAllNearest (grid, 7);
}

TEST (AllNearest, AreFoundWhereTheDensityJumps)
{
  Coordinates points;
  addDrawn (300, 0.0f, 1e-3f, points);
  addDrawn (300, 50.0f, 100.0f, points);
  addDrawn (10, -1e4f, 1.0f, points);
  expectAllNearest (points, 12);
}

TEST (AllNearest, AreFoundWhereTheDensityGrowsTowardsZero)
{
  Coordinates points;
  for (float edge = 1e-4f; edge < 1e4f; edge *= 2.0f)
    addDrawn (60, -0.5f * edge, edge, points);
  expectAllNearest (points, 12);
}

TEST (AllNearest, AreFoundAlongRingsOfALidar)
{
  Coordinates points; // on the ground, 1.7 m below the lidar at zero
  for (int ring = 1; ring <= 4; ++ring)
    for (int i = 0; i < 200; ++i) {
      const float azimuth = 0.03f * static_cast<float> (i);  // [rad]
      const float radius = 5.0f * static_cast<float> (ring); // [m]
      points.add (radius * std::cos (azimuth), radius * std::sin (azimuth), -1.7f);
    }
  expectAllNearest (points, 20);
}

TEST (AllNearest, MayBeAllOthers)
{
  Coordinates points;
  addDrawn (9, 0.0f, 1.0f, points);
  expectAllNearest (points, 8);
}

TEST (AllNearest, OfEqualPointsAreThoseOfLowestIndex)
{
  Coordinates points;
  for (int i = 0; i < 40; ++i)
    points.add (1.0f, 2.0f, 3.0f);
  expectAllNearest (points, 5);
}

TEST (AllNearest, AreFoundBesideManyEqualPoints)
{
  Coordinates points;
  for (int i = 0; i < 40; ++i)
    points.add (0.0f, 0.0f, 0.0f);
  addDrawn (100, 1.0f, 2.0f, points);
  expectAllNearest (points, 5);
}

TEST (AllNearest, AreFoundBesidePointsWhoseSquaredDistanceIsRoundedToZero)
{
  Coordinates points;
  for (int i = 0; i < 64; ++i)
    points.add (1e-30f * static_cast<float> (i), 0.0f, 0.0f);
  addDrawn (100, 1.0f, 2.0f, points);
  expectAllNearest (points, 5);
}

TEST (AllNearest, AreTheSameForAnyNumberOfThreads)
{
  Coordinates points;
  addDrawn (20000, 0.0f, 1.0f, points);
  const PointTree tree (points);
  const Indices nearest = findAllNearest (tree, 10, one_thread);
  ASSERT_EQ (nearest.size(), 10u * points.size());
  EXPECT_EQ (findAllNearest (tree, 10, 4), nearest);
}

TEST (AllNearest, AreFoundWhereSquaredDistancesAreInfiniteInSinglePrecision)
{
  Coordinates points;
  addDrawn (50, 0.0f, 1.0f, points);
  addDrawn (50, -1e30f, 3e30f, points);
  expectAllNearest (points, 12);
}

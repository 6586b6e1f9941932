// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/places.h"
#include "place_scene.h"

#include <set>

using namespace pcl_ops::internal;

TEST (Places, HaveTheirNearestOthers)
{
  const PlaceScene scene (drawnOn ({square_of_ground}, 5_cm, 1_mm), 12);
  const Places& places = scene.places;
  ASSERT_EQ (places.neighbors, 11u);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::set<std::uint32_t> others (places.nearestOf (i), places.nearestOf (i) + 11);
    EXPECT_EQ (others.size(), 11u);
    EXPECT_EQ (others.count (static_cast<std::uint32_t> (i)), 0u);
  }
}

TEST (Places, HaveSupportsThatGrow)
{
  const PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 1_mm));
  const Places& places = scene.places;
  ASSERT_GE (places.supports.size(), 3u);
  for (std::size_t level = 1; level < places.supports.size(); ++level) {
    EXPECT_GT (places.points_of_level[level], places.points_of_level[level - 1]);
    double before = 0.0;
    double now = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      before += places.supports[level - 1][i].width;
      now += places.supports[level][i].width;
    }
    EXPECT_GT (now, 1.4 * before);
  }
}

TEST (Places, ScatterByTheNoiseAndStandUpright)
{
  const PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 2_mm));
  double sum = 0.0;
  for (const Support& support : scene.places.supports[1]) {
    sum += support.scatter;
    ASSERT_GT (std::abs (support.normal.z()), 0.95f);
  }
  EXPECT_NEAR (sum / static_cast<double> (scene.places.size()), 2e-3, 2e-4);
}

TEST (Places, OnLevelsScatterByTheVarianceOfTheirStep)
{
  // A wall that leans, in steps of 4 cm: most of the nearest points are on one level.
  Coordinates points = drawnOn ({{{-1, -1, 4.8}, {2, 0, 0.6}, {0, 2, 0.2}}}, 1_cm, 0.0);
  for (float& z : points.z)
    z = static_cast<float> (4_cm * std::round (z / 4_cm));
  const PlaceScene scene (points);
  std::vector<float> scatter;
  for (const Support& support : scene.places.supports[0])
    scatter.push_back (support.scatter);
  EXPECT_GT (medianOf (scatter), 0.9 * 4_cm / std::sqrt (12.0)) << "the wall leans";
}

TEST (Places, AreAsDenseAsTheirPoints)
{
  const PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 0.0));
  std::vector<float> density (scene.places.density);
  EXPECT_NEAR (medianOf (density), 2500.0, 1500.0);
}

TEST (NeighborsOfCloud, GrowWithTheCloudWithinLimits)
{
  EXPECT_EQ (neighborsOfCloud (100, 1.0), 10u);
  EXPECT_LT (neighborsOfCloud (2000, 1.0), neighborsOfCloud (20000, 1.0));
  EXPECT_EQ (neighborsOfCloud (10'000'000, 1.0), 36u);
  EXPECT_EQ (neighborsOfCloud (10'000'000, 2.0), 72u);
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/depth_levels.h"
#include "place_scene.h"

#include <cmath>

using namespace pcl_ops::internal;

namespace {

const Surface slanted_wall = {{-1, -1, 4.8}, {2, 0, 0.6}, {0, 2, 0.2}};

// Points of the slanted wall with depths z rounded to a step [m].
Coordinates
onSteps (double step, double jitter = 0.0)
{
  Coordinates points = drawnOn ({slanted_wall}, 1_cm, 1_mm);
  RandomGenerator generator (seedOfTest());
  for (float& z : points.z)
    z = static_cast<float> (step * std::round (z / step) +
                            jitter * (drawUnit (generator) - 0.5));
  return points;
}

DepthLevels
levelsOf (const Coordinates& points)
{
  return findDepthLevels (points, PointTree (points));
}

} // namespace

TEST (DepthLevels, AreAsFarApartAsTheSteps)
{
  const DepthLevels levels = levelsOf (onSteps (4_cm));
  ASSERT_FALSE (levels.step.empty());
  EXPECT_NEAR (std::abs (levels.direction.z()), 1.0, 1e-6);
  for (const float step : levels.step)
    ASSERT_NEAR (step, 4e-2, 1e-3);
}

TEST (DepthLevels, AreSeenInAnyDirection)
{
  Coordinates points = onSteps (4_cm);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = points.x[i];
    points.x[i] = 0.8f * x - 0.6f * points.z[i];
    points.z[i] = 0.6f * x + 0.8f * points.z[i];
  }
  const DepthLevels levels = levelsOf (points);
  ASSERT_FALSE (levels.step.empty());
  EXPECT_NEAR (
      std::abs (levels.direction.dot (Eigen::Vector3d (-0.6, 0, 0.8))), 1.0, 1e-4);
}

TEST (DepthLevels, MayBeRoundedOrJittered)
{
  for (const double jitter : {2e-5, 1_mm}) {
    const DepthLevels levels = levelsOf (onSteps (4_cm, jitter));
    ASSERT_FALSE (levels.step.empty()) << jitter;
    EXPECT_NEAR (levels.step[0], 4e-2, 2e-3);
  }
}

TEST (DepthLevels, MayBeRoundedAcross)
{
  Coordinates points = drawnOn ({slanted_wall}, 5_mm, 0.0);
  const auto rounded = [] (double value) {
    return static_cast<float> (1_mm * std::round (value / 1_mm));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points.x[i];
    const double z = 1_cm * std::round (points.z[i] / 1_cm);
    points.x[i] = rounded (0.8 * x - 0.6 * z);
    points.y[i] = rounded (points.y[i]);
    points.z[i] = rounded (0.6 * x + 0.8 * z);
  }
  const DepthLevels levels = levelsOf (points);
  ASSERT_FALSE (levels.step.empty());
  EXPECT_NEAR (
      std::abs (levels.direction.dot (Eigen::Vector3d (-0.6, 0, 0.8))), 1.0, 1e-6);
  std::size_t right = 0;
  for (const float step : levels.step)
    right += std::abs (step - 1e-2) < 1e-3 ? 1 : 0;
  EXPECT_GT (right, points.size() * 9 / 10);
}

TEST (DepthLevels, AreNoneOfWhiteNoiseOfFacesAndOfFewPoints)
{
  EXPECT_TRUE (levelsOf (drawnOn ({slanted_wall}, 1_cm, 1_cm)).step.empty());
  // A box without noise has three directions.
  EXPECT_TRUE (levelsOf (drawnOn ({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}},
                                   {{0, 0, 0}, {2, 0, 0}, {0, 0, 2}},
                                   {{0, 0, 0}, {0, 2, 0}, {0, 0, 2}}},
                                  3_cm,
                                  0.0))
                   .step.empty());
  EXPECT_TRUE (levelsOf (drawnOn ({square_of_ground}, 5_cm, 0.0)).step.empty());
  // A wall, and a floor on a grid whose rows are no levels of depth.
  Coordinates grid;
  for (int i = 0; i < 2500; ++i) {
    const float first = 4e-2f * static_cast<float> (i / 50);
    const float second = 4e-2f * static_cast<float> (i % 50);
    grid.add (first, second, 2e-3f * static_cast<float> (i % 3));
    grid.add (3.0f, first, second);
  }
  EXPECT_TRUE (levelsOf (grid).step.empty());
  // A floor, and a few points of a leg at heights of their own.
  Coordinates floor = drawnOn ({square_of_ground}, 3_cm, 0.0);
  for (int i = 0; i < 20; ++i)
    floor.add (1.0f, 1.0f, 0.03f * static_cast<float> (i * i));
  EXPECT_TRUE (levelsOf (floor).step.empty());
}

TEST (DepthLevels, FarFromAllOthersAreNoFartherApartThanThose)
{
  Coordinates points = onSteps (4_cm);
  const Coordinates wall = drawnOn ({{{-1, -1, 7.0}, {2, 0, 0}, {0, 2, 0}}}, 2_cm, 0.0);
  for (std::size_t i = 0; i < wall.size(); ++i)
    points.add (wall.x[i], wall.y[i], wall.z[i]);
  const DepthLevels levels = levelsOf (points);
  ASSERT_FALSE (levels.step.empty());
  for (const float step : levels.step)
    ASSERT_NEAR (step, 4e-2, 1e-3);
}

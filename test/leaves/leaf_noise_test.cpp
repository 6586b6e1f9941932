// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/leaf_noise.h"

using namespace pcl_ops::internal;

TEST (LeafNoise, IsTheRmsDistanceOfThePoints)
{
  // Evenly up to 1 cm: an rms of 5.8 mm.
  LeafScene scene ({ground}, 1_cm, 6_mm);
  scene.addPlane (ground, 0.0, anywhere);
  measureNoise (scene.cloud, 1, scene.planes);
  for (const double noise : scene.planes.noise)
    EXPECT_NEAR (noise, 5.8e-3, 0.5e-3);
}

TEST (LeafNoise, IsThatOfThePlaceOnAPlane)
{
  Coordinates points = gridsOf ({ground}, 120);
  RandomGenerator generator (seedOfTest());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.x[i] > 1.0f)
      points.z[i] += static_cast<float> (3e-2 * (2.0 * drawUnit (generator) - 1.0));
  LeafScene scene (points, 1_cm);
  scene.addPlane (ground, 0.0, anywhere);
  measureNoise (scene.cloud, 1, scene.planes);
  for (std::size_t leaf = 0; leaf < scene.cloud.size(); ++leaf) {
    const double x = scene.centroid (leaf).x();
    if (x < 0.5) {
      EXPECT_LT (scene.planes.noise[leaf], 5_mm);
    }
    if (x > 1.5) {
      EXPECT_NEAR (scene.planes.noise[leaf], 1.73e-2, 2e-3);
    }
  }
}

TEST (LeafNoise, IsAtMostAFewTimesWhatIsExpected)
{
  // A plane 10 cm beside its leaves.
  LeafScene scene ({ground});
  scene.addPlane ({Eigen::Vector3d::UnitZ(), -0.15}, 0.0, anywhere);
  measureNoise (scene.cloud, 1, scene.planes);
  for (const double noise : scene.planes.noise) {
    EXPECT_GE (noise, 2_mm);
    EXPECT_LE (noise, 2_cm);
  }
}

TEST (LeafNoise, IsNotLessThanALeafCanHave)
{
  LeafScene scene ({ground});
  scene.addPlane (ground, 0.0, anywhere);
  measureNoise (scene.cloud, 1, scene.planes);
  EXPECT_EQ (scene.planes.noise, scene.cloud.min_noise);
}

TEST (LeafNoise, IsOfTheLeavesOfThePlaneAlone)
{
  // Beside an exact plane one of up to 3 cm of noise.
  Coordinates points = gridsOf ({{{0, 0, 0.05}, {1, 0, 0}, {0, 2, 0}}}, 120);
  addGrid (points, {{1, 0, 0.05}, {1, 0, 0}, {0, 2, 0}}, 120, 3_cm);
  LeafScene scene (points, 1_cm);
  scene.addPlane (ground, 0.0, before (1.0));
  scene.addPlane (ground, 0.0, behind (1.0));
  measureNoise (scene.cloud, 1, scene.planes);
  for (std::size_t leaf = 0; leaf < scene.cloud.size(); ++leaf)
    if (scene.centroid (leaf).x() < 1.0) {
      EXPECT_EQ (scene.planes.noise[leaf], scene.cloud.min_noise[leaf]);
    }
    else {
      EXPECT_GT (scene.planes.noise[leaf], 1_cm);
    }
}

TEST (LeafNoise, IsMeasuredOfChangedPlanesAlone)
{
  LeafScene scene ({ground}, 1_cm, 6_mm);
  scene.addPlane (ground, 7.0, before (1.0));
  scene.addPlane (ground, 7.0, behind (1.0));
  const std::vector<char> changed = {0, 1};
  measureNoise (scene.cloud, 1, scene.planes, &changed);
  for (std::size_t leaf = 0; leaf < scene.cloud.size(); ++leaf)
    EXPECT_EQ (scene.planes.noise[leaf] == 7.0, scene.centroid (leaf).x() < 1.0);
}

TEST (LeafNoise, IsNoneOfLeavesWithoutAPlane)
{
  LeafScene scene ({ground});
  scene.planes.noise.assign (scene.cloud.size(), 7.0);
  measureNoise (scene.cloud, 1, scene.planes);
  EXPECT_EQ (scene.planes.noise, std::vector<double> (scene.cloud.size(), 0.0));
}

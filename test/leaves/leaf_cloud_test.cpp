// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

TEST (LeafCloud, HasTheMomentsAndSizesOfItsLeaves)
{
  const LeafScene scene ({ground});
  ASSERT_EQ (scene.cloud.size(), 400u);
  for (std::size_t leaf = 0; leaf < scene.cloud.size(); ++leaf) {
    EXPECT_EQ (scene.cloud.moments[leaf].count, 36.0);
    EXPECT_NEAR (scene.centroid (leaf).z(), 0.05, 1e-6);
    EXPECT_DOUBLE_EQ (scene.cloud.edge[leaf], 10_cm);
    EXPECT_DOUBLE_EQ (scene.cloud.density[leaf], densityOf (36, level_of_10_cm));
  }
  EXPECT_NEAR (scene.centroid (scene.leafAt ({1.25, 0.65, 0.05})).x(), 1.25, 1e-6);
}

TEST (LeafCloud, ExpectsTheNoiseOfThePlace)
{
  const LeafScene scene (gridsOf ({ground}, 120), 7_mm);
  EXPECT_NEAR (scene.cloud.expectedNoise (0, 100.0), 7_mm, 1e-6);
  EXPECT_NEAR (scene.cloud.lowest_expected[0], 7_mm, 0.1e-3);
}

TEST (LeafCloud, HasALeastNoiseOfAboutWhatIsExpected)
{
  // Of a leaf that is exact: not zero, but a share of its edge where more is expected.
  for (const double expected : {1_mm, 1.0}) {
    const LeafScene scene (gridsOf ({ground}, 120), expected);
    for (const double noise : scene.cloud.min_noise) {
      EXPECT_GE (noise, std::min (expected, 1_mm));
      EXPECT_LE (noise, 5_mm);
    }
  }
}

TEST (LeafCloud, HasALeastNoiseOfAGoodShareOfAStep)
{
  // Depths of 50 values 8 cm apart.
  Coordinates positions = pointsInACube (5000, 5.0);
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions.z[i] = 0.08f * static_cast<float> (i % 50);
  const LeafScene scene (positions);
  const LeafCloud cloud = measureLeaves (scene.points,
                                         scene.expected,
                                         CoordinateSteps (scene.points),
                                         scene.cloud.leaves,
                                         2);
  double sum = 0.0;
  for (std::size_t leaf = 0; leaf < cloud.size(); ++leaf)
    sum += cloud.min_noise[leaf] / static_cast<double> (cloud.size());
  EXPECT_GT (sum, 2_cm);
  EXPECT_LT (sum, 8_cm);
}

TEST (LeafPlanes, HaveTheMomentsOfTheirLeaves)
{
  LeafScene scene ({ground});
  scene.addPlane (ground, 1_cm, before (0.5));
  scene.addPlane (ground, 1_cm, [] (const auto& at) { return at.x() > 1.9; });
  const std::vector<pcl_ops::Moments> moments =
      momentsOfPlanes (scene.cloud, scene.planes);
  ASSERT_EQ (moments.size(), 2u);
  EXPECT_EQ (moments[0].count, 100 * 36.0);
  EXPECT_EQ (moments[1].count, 20 * 36.0);
  EXPECT_NEAR (moments[0].centroid().x(), 0.25, 1e-6);
}

TEST (LeafPlanes, AreFittedToTheirLeaves)
{
  LeafScene scene ({ground, wall});
  const pcl_ops::Plane leaning = {Eigen::Vector3d (0.1, 0, 1).normalized(), 3.0};
  scene.addPlane (leaning, 1_cm, [] (const auto& at) { return at.x() > 0.1; });
  scene.addPlane (leaning, 1_cm, [] (const auto&) { return false; });
  refitPlanes (scene.cloud, scene.planes);
  EXPECT_TRUE (isNear (scene.planes.planes[0], ground, 1e-5, 1e-5));
  EXPECT_EQ (scene.planes.planes[1].offset, 3.0) << "without a leaf it stays";
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/leaf_surfels.h"

using namespace pcl_ops::internal;

namespace {

std::vector<LeafSurfel>
surfelsIn (const LeafScene& scene, int rings = 4, double min_points = 30.0)
{
  return orientLeaves (scene.cloud, scene.planes, {min_points, rings}, 1);
}

std::size_t
existing (const std::vector<LeafSurfel>& surfels)
{
  return static_cast<std::size_t> (std::count_if (
      surfels.begin(), surfels.end(), [] (const auto& s) { return s.exists(); }));
}

double
meanThickness (const std::vector<LeafSurfel>& surfels)
{
  double sum = 0.0;
  for (const LeafSurfel& surfel : surfels)
    sum += surfel.thickness;
  return sum / static_cast<double> (surfels.size());
}

} // namespace

TEST (LeafSurfels, HaveThePlaneOfTheSurfaceAndItsNoise)
{
  // Evenly up to 5 mm: an rms of 2.9 mm.
  const Surface tilted = {{0, 0, 0}, {2, 0, 0.6}, {0, 2, -0.4}};
  const LeafScene scene ({tilted}, 5_mm);
  for (const LeafSurfel& surfel : surfelsIn (scene)) {
    EXPECT_TRUE (isNear (surfel.plane, tilted, 3_deg, 6_cm));
    EXPECT_NEAR (surfel.noise, 2.9e-3, 1e-3);
    EXPECT_LT (surfel.thickness, 0.13);
  }
}

TEST (LeafSurfels, NearACornerAreThoseOfTheirOwnSurface)
{
  const LeafScene scene ({ground, wall}, 3_mm);
  const std::vector<LeafSurfel> surfels = surfelsIn (scene);
  for (std::size_t leaf = 0; leaf < surfels.size(); ++leaf) {
    const Eigen::Vector3d at = scene.centroid (leaf);
    if (at.x() > 0.1 || at.z() > 0.1) {
      EXPECT_TRUE (
          isNear (surfels[leaf].plane, at.x() > 0.1 ? ground : wall, 2_deg, 1_cm))
          << at.transpose();
    }
  }
}

TEST (LeafSurfels, NeedPoints)
{
  const Surface tile = {{0, 0, 0.05}, {0.1, 0, 0}, {0, 0.1, 0}};
  const LeafScene scene (gridsOf ({tile}, 6));
  ASSERT_EQ (scene.cloud.size(), 1u);
  EXPECT_TRUE (surfelsIn (scene, 4, 36.0)[0].exists());
  EXPECT_FALSE (surfelsIn (scene, 4, 37.0)[0].exists());
}

TEST (LeafSurfels, AreNotOfALine)
{
  const Surface line = {{0, 0.04, 0.05}, {2, 0, 0}, {0, 0.02, 0}};
  EXPECT_EQ (existing (surfelsIn (LeafScene (gridsOf ({line}, 120)))), 0u);
}

TEST (LeafSurfels, ComeFromLargerSurroundingsWherePointsAreNoisy)
{
  const LeafScene scene ({ground}, 8_cm);
  EXPECT_LT (meanThickness (surfelsIn (scene, 4)),
             0.7 * meanThickness (surfelsIn (scene, 1)));
}

TEST (LeafSurfels, AreOfLeavesWithoutAPlaneAlone)
{
  LeafScene scene ({ground});
  EXPECT_EQ (existing (surfelsIn (scene)), 400u);
  scene.addPlane (ground, 1_cm, before (0.5));
  EXPECT_EQ (existing (surfelsIn (scene)), 300u);
  scene.planes.is_curved.assign (400, 1);
  EXPECT_EQ (existing (surfelsIn (scene)), 0u);
}

TEST (LeafSurfels, DoNotHideAFinerSurface)
{
  // Exact surfaces 2 cm apart in leaves one above the other are not one of 1 cm of
  // noise; points evenly between them are.
  const LeafScene two (
      {{{0, 0, 0.09}, {2, 0, 0}, {0, 2, 0}}, {{0, 0, 0.11}, {2, 0, 0}, {0, 2, 0}}},
      0.0,
      2e-4);
  const LeafScene one (gridsOf ({{{0, 0, 0.1}, {2, 0, 0}, {0, 2, 0}}}, 240, 1.7e-2),
                       2e-4);
  EXPECT_EQ (two.cloud.size(), 800u);
  EXPECT_EQ (one.cloud.size(), 800u);
  EXPECT_EQ (existing (surfelsIn (two)), 0u);
  EXPECT_EQ (existing (surfelsIn (one)), 800u);
}

TEST (LeafSurfels, AreNotOfWhatIsFarNoisierThanMostOfTheCloud)
{
  const Surface beside = {{3, 0, 0.05}, {1, 0, 0}, {0, 1, 0}};
  Coordinates points = gridsOf ({ground}, 120, 1_mm);
  addGrid (points, beside, 60, 3_cm);
  const LeafScene scene (points);
  EXPECT_EQ (existing (surfelsIn (scene)), 400u);
  EXPECT_EQ (existing (surfelsIn (LeafScene (gridsOf ({beside}, 60, 3_cm)))), 100u);
}

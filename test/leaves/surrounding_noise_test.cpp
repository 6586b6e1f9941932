// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/surrounding_noise.h"

using pcl_ops::Labels;
using namespace pcl_ops::internal;

namespace {

constexpr double points_around = 100.0;

/** \brief Of all leaves of a scene, on one plane. */
std::optional<double>
noiseOf (const LeafScene& scene)
{
  const Labels one_plane (scene.cloud.size(), 0);
  return surroundingNoise (
      scene.cloud, one_plane, upTo (scene.cloud.size()), points_around);
}

/** \brief A ground with a normal scatter. */
Coordinates
noisyGround (double noise)
{
  Coordinates points = gridsOf ({ground}, 120);
  RandomGenerator generator (seedOfTest());
  for (float& z : points.z)
    z += static_cast<float> (noise * drawNormal (generator));
  return points;
}

} // namespace

TEST (SurroundingNoise, IsTheScatterOfPointsAboutTheirSurface)
{
  const LeafScene scene (noisyGround (1_cm), 9_mm);
  EXPECT_NEAR (noiseOf (scene).value_or (0.0), 1_cm, 5e-4);
}

TEST (SurroundingNoise, DoesNotGrowWithTheBendOfAPlane)
{
  Coordinates hill = noisyGround (1_cm);
  for (std::size_t i = 0; i < hill.size(); ++i)
    hill.z[i] -= 0.1f * hill.x[i] * hill.x[i];
  const LeafScene scene (hill, 9_mm);
  EXPECT_NEAR (noiseOf (scene).value_or (0.0), 1_cm, 1e-3);
}

TEST (SurroundingNoise, StaysNearWhatTheCloudShowsElsewhere)
{
  EXPECT_NEAR (
      noiseOf (LeafScene (noisyGround (5_cm), 1_cm)).value_or (0.0), 1.25e-2, 1e-3);
  EXPECT_NEAR (
      noiseOf (LeafScene (noisyGround (1_mm), 1_cm)).value_or (0.0), 1_cm, 1e-3);
}

TEST (SurroundingNoise, IsNotKnownOfPointsOnLines)
{
  // Beams of a lidar, half a meter apart.
  Coordinates points;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 800; ++column)
      points.add (
          0.01f * static_cast<float> (column), 0.5f * static_cast<float> (row), 0.0f);
  EXPECT_EQ (noiseOf (LeafScene (points)), std::nullopt);
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/principal_axes.h"
#include "leaf_scene.h"
#include "leaves/plane_splitting.h"

using pcl_ops::Labels;
using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

// Points moved by up to a noise have this rms.
double
rmsOfNoise (double noise)
{
  return noise / std::sqrt (3.0);
}

/** \brief All leaves of a scene on one plane, split if that is thick. */
std::vector<char>
splitWhole (LeafScene& scene)
{
  constexpr double points_around = 100.0;
  scene.addPlane (ground, 1_cm, anywhere);
  refitPlanes (scene.cloud, scene.planes);
  return splitThickPlanes (scene.cloud, points_around, 2, scene.planes);
}

double
rmsOf (const LeafScene& scene, std::int32_t plane)
{
  const auto moments = momentsOfPlanes (scene.cloud, scene.planes);
  return std::sqrt (principalAxes (moments[plane].covariance()).values[0]);
}

Coordinates
hill (double noise)
{
  return pointsOver (
      4_m, noise, [] (double x, double y) { return -0.05 * (x * x + y * y); });
}

} // namespace

TEST (PlaneSplitting, DividesAHillIntoPiecesAsThinAsTheirSurroundings)
{
  LeafScene scene (hill (2_cm), rmsOfNoise (2_cm));
  splitWhole (scene);
  EXPECT_GT (scene.planesWithLeaves(), 2u);
  EXPECT_LT (scene.planesWithLeaves(), 40u);
  EXPECT_EQ (scene.leavesOn (no_plane), 0u);
  for (std::size_t p = 0; p < scene.planes.planes.size(); ++p)
    EXPECT_LT (rmsOf (scene, static_cast<std::int32_t> (p)),
               max_thickness_of_plane * rmsOfNoise (2_cm));
}

TEST (PlaneSplitting, PartsTheTwoSidesOfARoof)
{
  LeafScene scene (pointsOver (
      2_m, 1_cm, [] (double x, double) { return 1.0 - 0.5 * std::abs (x); }));
  splitWhole (scene);
  // What is left is a strip along the ridge.
  const std::int32_t left = scene.planes.plane_of_leaf[scene.leafAt ({-1, 0, 0.5})];
  const std::int32_t right = scene.planes.plane_of_leaf[scene.leafAt ({1, 0, 0.5})];
  EXPECT_NE (left, right);
  for (std::size_t leaf = 0; leaf < scene.cloud.size(); ++leaf) {
    const double x = scene.centroid (leaf).x();
    if (std::abs (x) > 0.5) {
      ASSERT_EQ (scene.planes.plane_of_leaf[leaf], x < 0.0 ? left : right);
    }
  }
}

TEST (PlaneSplitting, PartsTerracesAtTheirStep)
{
  LeafScene scene (
      pointsOver (2_m, 5_mm, [] (double x, double) { return x < 0.0 ? 0.0 : 0.5; }));
  splitWhole (scene);
  EXPECT_EQ (scene.planesWithLeaves(), 2u);
  EXPECT_LT (rmsOf (scene, 0), 1_cm);
  EXPECT_LT (rmsOf (scene, 1), 1_cm);
}

TEST (PlaneSplitting, LeavesNoisyAndSlightlyBentPlanesWhole)
{
  LeafScene noisy (pointsOver (2_m, 5_cm, [] (double, double) { return 0.0; }),
                   rmsOfNoise (5_cm));
  EXPECT_EQ (splitWhole (noisy), std::vector<char>{0});
  // A ground that bends by seven times the rms of its noise.
  LeafScene bent (
      pointsOver (2_m,
                  1_cm,
                  [] (double x, double) { return 13e-2 * std::cos (x * M_PI / 4.0); }),
      rmsOfNoise (1_cm));
  EXPECT_EQ (splitWhole (bent), std::vector<char>{0});
  EXPECT_EQ (bent.leavesOn (0), bent.cloud.size());
}

TEST (PlaneSplitting, TakesARoughSlopeForNoPlaneWhereOtherSurfacesAreSmooth)
{
  const auto rough = pointsOver (2_m, 5_cm, [] (double x, double) { return 0.3 * x; });
  LeafScene scene (rough, 1_mm);
  EXPECT_EQ (splitWhole (scene), std::vector<char>{1});
  EXPECT_EQ (scene.leavesOn (no_plane), scene.cloud.size());
}

TEST (PlaneSplitting, LeavesQuantizedPlanesWhole)
{
  // Steps of 5 cm, wider than a leaf: nothing scatters on them.
  const auto steps = pointsOver (
      2_m, 0.0, [] (double x, double) { return 5e-2 * std::round (2 * x); });
  LeafScene scene (steps, 1.5e-2);
  EXPECT_EQ (splitWhole (scene), std::vector<char>{0});
}

TEST (PlaneSplitting, DoesNotJudgePointsOnLines)
{
  // Beams of a lidar across a hill, half a meter apart: what scatters along a beam says
  // nothing of the ground between them.
  Coordinates points;
  for (int row = -8; row <= 8; ++row)
    for (int column = -400; column <= 400; ++column) {
      const auto x = 0.01f * static_cast<float> (column);
      const auto y = 0.5f * static_cast<float> (row);
      points.add (x, y, -0.1f * (x * x + y * y));
    }
  LeafScene scene (points);
  EXPECT_EQ (splitWhole (scene), std::vector<char>{0});
}

TEST (PlaneSplitting, TakesWhatIsThickHoweverSmallFromItsPlane)
{
  // Each leaf, flat by itself, has a height of its own.
  Coordinates points = gridsOf ({ground}, 120);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int row = static_cast<int> (10.0f * points.x[i]);
    const int column = static_cast<int> (10.0f * points.y[i]);
    points.z[i] += 0.02f * static_cast<float> ((7 * row + 12 * column) % 31);
  }
  LeafScene scene (points);
  constexpr double points_of_a_leaf = 36.0;
  scene.addPlane (ground, 1_cm, anywhere);
  refitPlanes (scene.cloud, scene.planes);
  splitThickPlanes (scene.cloud, points_of_a_leaf, 1, scene.planes);
  EXPECT_EQ (scene.leavesOn (no_plane), scene.cloud.size());
}

TEST (PlaneSplitting, LeavesOtherPlanesAsTheyAre)
{
  LeafScene scene (hill (2_cm), rmsOfNoise (2_cm));
  scene.addPlane (ground, 1_cm, anywhere);
  scene.addPlane (
      ground, 1_cm, [] (const auto& at) { return at.x() > 3.2 && at.y() > 3.2; });
  scene.label (no_plane, 0.0, [] (const auto& at) { return at.x() < -3.5; });
  refitPlanes (scene.cloud, scene.planes);
  const std::size_t on_second = scene.leavesOn (1);
  const std::size_t on_none = scene.leavesOn (no_plane);
  const std::vector<char> changed =
      splitThickPlanes (scene.cloud, 100.0, 2, scene.planes);
  EXPECT_EQ (changed[0], 1);
  EXPECT_EQ (changed[1], 0);
  EXPECT_EQ (scene.leavesOn (1), on_second);
  EXPECT_EQ (scene.leavesOn (no_plane), on_none);
}

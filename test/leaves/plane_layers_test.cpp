// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/plane_layers.h"

using pcl_ops::Labels;
using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

const pcl_ops::Plane middle = {Eigen::Vector3d::UnitZ(), -0.05};

/** \brief Two grounds so far apart in the same leaves. */
std::vector<Surface>
layersApart (double distance)
{
  return {{{0, 0, 0.05 - 0.5 * distance}, {2, 0, 0}, {0, 2, 0}},
          {{0, 0, 0.05 + 0.5 * distance}, {2, 0, 0}, {0, 2, 0}}};
}

/** \brief All points of a scene on one plane, split. */
struct Split {
  explicit Split (LeafScene& scene,
                  bool is_plane_kept = true,
                  std::optional<double> theta_h = std::nullopt)
  : labels (scene.points.size(), 0), is_kept (1, is_plane_kept)
  {
    scene.addPlane (middle, 1_cm, anywhere);
    splitLayers (scene.cloud, scene.planes, theta_h, labels, is_kept);
  }

  Labels labels;
  std::vector<char> is_kept;
};

} // namespace

TEST (PlaneLayers, AreTheTwoSidesOfAThinWall)
{
  LeafScene scene (layersApart (4_cm), 3_mm);
  const Split split (scene);
  EXPECT_EQ (split.is_kept, (std::vector<char>{1, 1}));
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    ASSERT_EQ (split.labels[i], scene.points.z[i] < 0.05f ? 0 : 1);
}

TEST (PlaneLayers, AreNoneOfOneNoisyPlane)
{
  LeafScene even (std::vector<Surface>{ground}, 3_cm, 1_cm);
  EXPECT_EQ (Split (even).is_kept.size(), 1u);
  Coordinates points = gridsOf ({ground}, 120);
  RandomGenerator generator (seedOfTest());
  for (float& z : points.z)
    z += static_cast<float> (1e-2 * drawNormal (generator));
  LeafScene normal (points);
  EXPECT_EQ (Split (normal).is_kept.size(), 1u);
}

TEST (PlaneLayers, AreFartherApartThanTheLeastNoise)
{
  LeafScene scene (layersApart (1_mm));
  EXPECT_EQ (Split (scene).is_kept.size(), 1u);
}

TEST (PlaneLayers, AreFartherApartThanAGivenThreshold)
{
  for (const double theta_h : {3_cm, 5_cm}) {
    LeafScene scene (layersApart (4_cm), 3_mm);
    EXPECT_EQ (Split (scene, true, theta_h).is_kept.size(), theta_h < 4_cm ? 2u : 1u);
  }
}

TEST (PlaneLayers, NeedPoints)
{
  LeafScene scene (gridsOf (layersApart (4_cm), 4));
  EXPECT_EQ (Split (scene).is_kept.size(), 1u);
}

TEST (PlaneLayers, AreLookedForInPlanesThatAreKept)
{
  LeafScene scene (layersApart (4_cm), 3_mm);
  const Split split (scene, false);
  EXPECT_EQ (split.is_kept.size(), 1u);
  EXPECT_EQ (split.labels, Labels (scene.points.size(), 0));
}

TEST (PlaneLayers, LeavePointsOnNoPlaneAlone)
{
  LeafScene scene (layersApart (4_cm), 3_mm);
  scene.addPlane (middle, 1_cm, anywhere);
  Labels labels (scene.points.size(), 0);
  labels[0] = labels[20000] = no_plane;
  std::vector<char> is_kept = {1};
  splitLayers (scene.cloud, scene.planes, std::nullopt, labels, is_kept);
  EXPECT_EQ (labels[0], no_plane);
  EXPECT_EQ (labels[20000], no_plane);
  EXPECT_EQ (is_kept.size(), 2u);
}

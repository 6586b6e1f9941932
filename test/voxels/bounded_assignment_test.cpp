// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/bounded_assignment.h"

using pcl_ops::Labels;
using pcl_ops::no_plane;
using pcl_ops::Plane;
using namespace pcl_ops::internal;

namespace {

AssignedPoints
assign (const VoxelScene& scene)
{
  AssignedPoints assigned{Labels (scene.points.size(), no_plane), {}};
  assignToBoundedPlanes (
      scene.points, scene.grid(), scene.planes, std::nullopt, 4.0, 1, {}, assigned);
  return assigned;
}

} // namespace

TEST (BoundedAssignment, GivesTheMomentsOfThePointsItLabels)
{
  const VoxelScene scene ({{ground}, {wall}}, 5_mm);
  const auto assigned = assign (scene);
  const auto expected = momentsOfLabels (scene.points, assigned.labels, 2, 1);
  ASSERT_EQ (assigned.moments.size(), 2u);
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_GT (assigned.moments[p].count, 14000.0);
    EXPECT_EQ (assigned.moments[p].count, expected[p].count);
    EXPECT_LT ((assigned.moments[p].sum - expected[p].sum).norm(), 1e-6);
  }
}

TEST (BoundedAssignment, GivesAPointBetweenPlanesToTheNoisierAndOneOnBothToTheCleaner)
{
  // The points lie at z = 5 cm. Left of x = 1 m a plane is this far below them, right
  // of it another plane is above them.
  VoxelScene scene ({{ground}});
  scene.label (1, [] (const auto& at) { return at.x() > 1.0; });
  for (const double off : {3_cm, 1_mm})
    for (const std::int32_t noisier : {0, 1}) {
      scene.planes.planes = {Plane{Eigen::Vector3d::UnitZ(), off - 5_cm},
                             Plane{Eigen::Vector3d::UnitZ(), -off - 5_cm}};
      scene.planes.noise = {noisier == 0 ? 4_cm : 1_cm, noisier == 1 ? 4_cm : 1_cm};
      const std::int32_t expected = off > 1_cm ? noisier : 1 - noisier;
      const Labels labels = assign (scene).labels;
      for (std::size_t i = 0; i < labels.size(); ++i)
        EXPECT_TRUE (std::abs (scene.points.x[i] - 1.0f) > 0.1f ||
                     labels[i] == expected);
    }
}

TEST (BoundedAssignment, TakesPointsUpToAMultipleOfTheNoise)
{
  // Four times 6 mm; each point in a voxel of its own, above the ground's.
  VoxelScene scene ({{{{0, 0, 0.09}, {2, 0, 0}, {0, 2, 0}}}});
  const std::size_t on_the_ground = scene.points.size();
  scene.points.add (0.55f, 0.55f, 0.105f);
  scene.points.add (1.55f, 0.55f, 0.120f);
  scene.voxelize();
  scene.label (no_plane, [] (const auto& at) { return at.z() > 0.1; });
  const Labels labels = assign (scene).labels;
  EXPECT_EQ (labels[on_the_ground], 0) << "15 mm off";
  EXPECT_EQ (labels[on_the_ground + 1], no_plane) << "30 mm off";
}

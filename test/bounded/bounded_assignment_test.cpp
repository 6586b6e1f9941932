// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/bounded_assignment.h"
#include "voxel_scene.h"

using pcl_ops::Labels;
using pcl_ops::no_plane;
using pcl_ops::Plane;
using namespace pcl_ops::internal;

namespace {

AssignedPoints
assign (const VoxelScene& scene)
{
  AssignedPoints assigned{Labels (scene.points.size(), no_plane), {}};
  assignToBoundedPlanes (scene.points,
                         scene.voxelized.finest.order,
                         scene.grid(),
                         scene.planes,
                         std::nullopt,
                         4.0,
                         1,
                         {},
                         assigned);
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

TEST (BoundedAssignment, GivesAPointBetweenTwoPlanesToTheNoisierOne)
{
  // Points at 5 cm; left of x = 1 a plane 3 cm below them, right of it one 3 cm above.
  VoxelScene scene ({{ground}});
  scene.planes.planes = {Plane{Eigen::Vector3d::UnitZ(), -0.02},
                         Plane{Eigen::Vector3d::UnitZ(), -0.08}};
  scene.label (1, [] (const auto& at) { return at.x() > 1.0; });
  for (const std::int32_t noisier : {0, 1}) {
    scene.planes.noise = {noisier == 0 ? 4_cm : 1_cm, noisier == 1 ? 4_cm : 1_cm};
    const Labels labels = assign (scene).labels;
    for (std::size_t i = 0; i < scene.points.size(); ++i)
      EXPECT_TRUE (std::abs (scene.points.x[i] - 1.0f) > 0.1f || labels[i] == noisier);
  }
}

TEST (BoundedAssignment, GivesAPointThatIsOnBothOfTwoPlanesToTheCleanerOne)
{
  // As the test before, but both planes are within a millimeter of the points.
  VoxelScene scene ({{ground}});
  scene.planes.planes = {Plane{Eigen::Vector3d::UnitZ(), -0.049},
                         Plane{Eigen::Vector3d::UnitZ(), -0.051}};
  scene.label (1, [] (const auto& at) { return at.x() > 1.0; });
  for (const std::int32_t cleaner : {0, 1}) {
    scene.planes.noise = {cleaner == 0 ? 1_cm : 4_cm, cleaner == 1 ? 1_cm : 4_cm};
    const Labels labels = assign (scene).labels;
    for (std::size_t i = 0; i < scene.points.size(); ++i)
      EXPECT_TRUE (std::abs (scene.points.x[i] - 1.0f) > 0.1f || labels[i] == cleaner);
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
  scene.planes.plane_of_voxel.assign (scene.grid().size(), 0);
  scene.label (no_plane, [] (const auto& at) { return at.z() > 0.1; });
  const Labels labels = assign (scene).labels;
  EXPECT_EQ (labels[on_the_ground], 0) << "15 mm off";
  EXPECT_EQ (labels[on_the_ground + 1], no_plane) << "30 mm off";
}

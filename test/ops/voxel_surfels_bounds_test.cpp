// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surfel_scene.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

const Surface ground = {{0, 0, 0.05}, {2, 0, 0}, {0, 2, 0}};
const Surface wall = {{0.05, 0, 0}, {0, 2, 0}, {0, 0, 2}};

} // namespace

TEST (VoxelSurfels, BoundGrowsPlanes)
{
  VoxelScene scene ({{ground}});
  scene.label (no_plane, [] (const auto& at) { return at.x() > 1.5; });
  EXPECT_EQ (voxelsOn (0, SurfelScene (pointsOf ({ground})).bound (scene)), 400u);
}

TEST (VoxelSurfels, BoundAbsorbsASplinter)
{
  // In a corner of 3 x 3 voxels, too few to say anything about where the plane is.
  VoxelScene scene ({{ground}}, 5_mm);
  scene.planes.planes.push_back (scene.planes.planes[0]);
  scene.label (1, [] (const auto& at) { return at.x() < 0.3 && at.y() < 0.3; });
  SurfelScene stages (pointsOf ({ground}, 5_mm));
  stages.parameters.merging.enabled = false;
  EXPECT_EQ (stages.bound (scene).size(), 1u);
}

TEST (VoxelSurfels, BoundTellsCoarseVoxelsWhatTheirPlanesBecame)
{
  // The first two are one; the third becomes the second.
  VoxelScene scene ({{{{0, 0, 0.05}, {1, 0, 0}, {0, 2, 0}}},
                     {{{1, 0, 0.05}, {1, 0, 0}, {0, 2, 0}}},
                     {{{0, 0, 1.05}, {2, 0, 0}, {0, 2, 0}}}},
                    5_mm);
  const RefinedPlanes planes = SurfelScene (pointsOf ({ground})).boundAll (scene);
  ASSERT_EQ (planes.finer.planes.size(), 2u);
  const pcl_ops::Labels& became = planes.coarse.plane_of_voxel;
  EXPECT_EQ (became[0], became[1]);
  EXPECT_NE (became[0], became[2]);
  ASSERT_EQ (planes.coarse.size(), 2u);
  EXPECT_NEAR (std::abs (planes.coarse.planes[became[2]].offset), 1.05, 1_cm);
}

TEST (VoxelSurfels, BoundMergesPlanesThatDoNotTouch)
{
  VoxelScene scene ({{ground}, {{{3, 0, 0.05}, {1, 0, 0}, {0, 2, 0}}}});
  const SurfelScene stages (pointsOf ({ground}));
  const BoundedPlanes planes = stages.bound (scene);
  EXPECT_EQ (planes.size(), 1u);
  EXPECT_EQ (voxelsOn (0, planes), scene.grid().size());
}

TEST (VoxelSurfels, BoundKeepsApartWhatNoiseDoesNotExplain)
{
  // 4 cm higher, and without any noise: nearer than theta_h of the paper all the same.
  VoxelScene scene ({{ground}, {{{3, 0, 0.09}, {1, 0, 0}, {0, 2, 0}}}});
  const SurfelScene stages (pointsOf ({ground}));
  EXPECT_EQ (stages.bound (scene).size(), 2u);
}

TEST (VoxelSurfels, BoundHandsVoxelsToTheNearerPlane)
{
  VoxelScene scene ({{ground}, {wall}});
  scene.label (1, [] (const auto& at) { return at.x() < 0.2 && at.z() < 0.1; });
  const SurfelScene stages (pointsOf ({ground}));
  const BoundedPlanes planes = stages.bound (scene);
  for (std::size_t i = 0; i < scene.grid().size(); ++i)
    if (scene.centroid (i).x() > 0.1) {
      const auto plane = static_cast<std::size_t> (planes.plane_of_voxel[i]);
      EXPECT_GT (std::abs (planes.planes[plane].normal.z()), 0.9);
    }
}

TEST (VoxelSurfels, BoundMeasuresTheNoiseOfWhatItSettled)
{
  VoxelScene scene ({{ground}}, 3_cm);
  const SurfelScene stages (pointsOf ({ground}));
  for (const double noise : stages.bound (scene).noise)
    EXPECT_NEAR (noise, 3_cm / std::sqrt (3.0), 3_mm);
}

TEST (VoxelSurfels, AssignNoPointWhereThereAreNoVoxels)
{
  const SurfelScene stages (pointsOf ({ground}));
  EXPECT_EQ (
      stages.policy.assign (stages.points, VoxelizedPoints(), RefinedPlanes()).labels,
      pcl_ops::Labels (stages.points.size(), no_plane));
}

TEST (VoxelSurfels, AssignPointsOfCoarseAndOfFinerVoxels)
{
  // Ground in coarse voxels, a narrow board in finer ones; both get all their points.
  const Surface board = {{0, 0, 1.01}, {1.5, 0, 0}, {0, 0.1, 0}};
  const SurfelScene stages (pointsOf ({ground, board}));
  const VoxelizedPoints voxelized = stages.sample();
  RefinedPlanes planes = stages.extract();
  stages.policy.bound (stages.points, voxelized, planes);
  const AssignedPoints assigned =
      stages.policy.assign (stages.points, voxelized, planes);
  const auto on = [&] (std::int32_t plane) {
    return std::count (assigned.labels.begin(), assigned.labels.end(), plane);
  };
  ASSERT_EQ (assigned.moments.size(), 2u);
  for (const std::int32_t plane : {0, 1}) {
    EXPECT_EQ (on (plane), 14400);
    EXPECT_EQ (assigned.moments[static_cast<std::size_t> (plane)].count, 14400.0);
  }
}

TEST (VoxelSurfels, AssignCountsEachPointOnce)
{
  // A board stands on the ground: the ground below it is looked at in finer voxels,
  // too.
  const SurfelScene stages (
      pointsOf ({ground, {{0, 1.05, 0.1}, {1.5, 0, 0}, {0, 0, 0.1}}}));
  const VoxelizedPoints voxelized = stages.sample();
  RefinedPlanes planes = stages.extract();
  stages.policy.bound (stages.points, voxelized, planes);
  const AssignedPoints assigned =
      stages.policy.assign (stages.points, voxelized, planes);
  ASSERT_EQ (assigned.moments.size(), 2u);
  const auto expected = momentsOfLabels (stages.points, assigned.labels, 2, 1);
  for (std::size_t p = 0; p < 2; ++p)
    EXPECT_EQ (assigned.moments[p].count, expected[p].count);
}

TEST (VoxelSurfels, MergeNothingThatBoundsKeptApart)
{
  const Points points = pointsOf ({ground, ground});
  pcl_ops::Labels labels (points.size(), 0);
  std::fill (labels.begin() + 14400, labels.end(), 1);
  const SurfelScene stages (points);
  const LabelledPlanes found =
      stages.policy.merge ({labels, momentsOfLabels (points, labels, 2, 1)});
  EXPECT_EQ (found.planes.fits.size(), 2u) << "of one and the same ground";
}

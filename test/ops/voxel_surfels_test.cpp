// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surfel_scene.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

const Surface ground = {{0, 0, 0.05}, {2, 0, 0}, {0, 2, 0}};
const Surface wall = {{0.05, 0, 0}, {0, 2, 0}, {0, 0, 2}};

} // namespace

TEST (VoxelSurfels, SampleVoxelsOfTheGivenSize)
{
  SurfelScene stages (pointsOf ({ground}));
  EXPECT_EQ (stages.sample().grid.voxel_size, 10_cm);
  EXPECT_EQ (stages.sample().grid.size(), 400u);
}

TEST (VoxelSurfels, SampleMoreVoxelsAtALargerRate)
{
  SurfelScene stages (pointsOf ({ground}));
  stages.parameters.surfels.voxel_size.reset();
  stages.parameters.sampling_rate = 0.003;
  const std::size_t few = stages.sample().grid.size();
  stages.parameters.sampling_rate = 0.03;
  EXPECT_GT (stages.sample().grid.size(), 5 * few);
}

TEST (VoxelSurfels, SampleNothingOfPointsThatSpanNothing)
{
  Points point;
  point.add (1, 2, 3);
  SurfelScene stages (point);
  stages.parameters.surfels.voxel_size.reset();
  EXPECT_EQ (stages.sample().grid.size(), 0u);
}

TEST (VoxelSurfels, OrientVoxelsWithPointsEnough)
{
  // 36 points in each voxel, 9 voxels around: 324 points, at the corners 144.
  SurfelScene stages (pointsOf ({ground}));
  const VoxelizedPoints voxelized = stages.sample();
  const auto with_k = [&] (int k) {
    stages.parameters.k = k;
    const auto surfels = stages.policy.orient (stages.points, voxelized);
    return std::count_if (
        surfels.begin(), surfels.end(), [] (const auto& s) { return s.has_value(); });
  };
  EXPECT_EQ (with_k (30), 400);
  stages.parameters.surfels.resolutions = 1;
  EXPECT_EQ (with_k (325), 0);
}

TEST (VoxelSurfels, AskForAsManyPointsAsSomeAverageVoxelsHold)
{
  SurfelScene stages (pointsOf ({ground}));
  stages.parameters.surfels.resolutions = 1;
  stages.parameters.surfels.least_average_voxels = 9.1;
  for (const auto& surfel : stages.policy.orient (stages.points, stages.sample()))
    EXPECT_FALSE (surfel) << "nine voxels are never 9.1";
}

TEST (VoxelSurfels, ExtractGroundAndWallInCoarseVoxels)
{
  const RefinedPlanes planes = SurfelScene (pointsOf ({ground, wall}, 5_mm)).extract();
  EXPECT_EQ (planes.size(), 2u);
  EXPECT_EQ (planes.coarse.size(), 2u);
  EXPECT_LE (voxelsOn (no_plane, planes.coarse), 60u) << "where they meet";
}

TEST (VoxelSurfels, ExtractFillsHolesInPlanes)
{
  // A voxel of the ground without a surfel, as if things lay there.
  const SurfelScene stages (pointsOf ({ground}));
  const VoxelizedPoints voxelized = stages.sample();
  auto surfels = stages.policy.orient (stages.points, voxelized);
  surfels[210].reset();
  const auto planes = stages.policy.extract (stages.points, voxelized, surfels);
  EXPECT_EQ (voxelsOn (no_plane, planes.coarse), 0u);
}

TEST (VoxelSurfels, ExtractMeasuresTheNoiseOfCoarsePlanes)
{
  // What the surfels say of it is ten times too much.
  const SurfelScene stages (pointsOf ({ground}, 1_cm));
  const VoxelizedPoints voxelized = stages.sample();
  auto surfels = stages.policy.orient (stages.points, voxelized);
  for (auto& surfel : surfels)
    surfel->noise = 6_cm;
  const auto planes = stages.policy.extract (stages.points, voxelized, surfels);
  for (const double noise : planes.coarse.noise)
    EXPECT_NEAR (noise, 1_cm / std::sqrt (3.0), 1_mm);
}

TEST (VoxelSurfels, ExtractJoinsCoarsePlanesThatAreOne)
{
  // A ground with a gap in it.
  const Surface beyond = {{3, 0, 0.05}, {2, 0, 0}, {0, 2, 0}};
  const RefinedPlanes planes =
      SurfelScene (pointsOf ({ground, beyond}, 5_mm)).extract();
  EXPECT_EQ (planes.size(), 2u) << "found, before they were one";
  EXPECT_EQ (planes.coarse.size(), 1u);
  EXPECT_EQ (voxelsOn (0, planes.coarse), 800u);
}

TEST (VoxelSurfels, ExtractLooksAtNothingTwice)
{
  const RefinedPlanes planes = SurfelScene (pointsOf ({ground})).extract();
  EXPECT_EQ (planes.size(), 1u);
  EXPECT_TRUE (planes.finer.points.empty()) << "all of it is on the coarse plane";
}

TEST (VoxelSurfels, ExtractFindsANarrowBoardInFinerVoxelsOnly)
{
  // 15 voxels of 10 cm are fewer than the 20 a plane needs; of 5 cm there are 60.
  const Surface board = {{0, 0, 1.01}, {1.5, 0, 0}, {0, 0.1, 0}};
  const RefinedPlanes planes = SurfelScene (pointsOf ({ground, board})).extract();
  EXPECT_EQ (planes.coarse.size(), 1u);
  ASSERT_EQ (planes.finer.planes.size(), 2u);
  EXPECT_EQ (planes.size(), 2u) << "found";
  expectPlaneNear (planes.finer.planes.planes[0], ground, 1e-3, 1e-3);
  expectPlaneNear (planes.finer.planes.planes[1], board, 1e-3, 1e-3);
}

TEST (VoxelSurfels, ExtractNoPlaneOfCoarseSurfelsThatAreNotSure)
{
  SurfelScene stages (pointsOf ({ground}));
  const VoxelizedPoints voxelized = stages.sample();
  auto surfels = stages.policy.orient (stages.points, voxelized);
  for (const double times_sure : {0.9, 1.1}) {
    for (auto& surfel : surfels)
      surfel->thickness = times_sure * stages.parameters.surfels.sure_thickness;
    const auto planes = stages.policy.extract (stages.points, voxelized, surfels);
    EXPECT_EQ (planes.coarse.size(), times_sure < 1.0 ? 1u : 0u);
    EXPECT_EQ (planes.size(), 1u) << "finer voxels find it all the same";
  }
}

TEST (VoxelSurfels, ExtractThickerSurfelsInFinerVoxels)
{
  // Points up to 5 cm off: thick at any resolution there is.
  SurfelScene stages (pointsOf ({ground}, 4_cm));
  stages.parameters.surfels.resolutions = 1;
  stages.parameters.surfels.sure_thickness = 0.0;
  stages.parameters.surfels.largest_thickness = 0.0;
  EXPECT_EQ (stages.extract().size(), 0u);
  stages.parameters.surfels.largest_thickness = 1.0;
  const RefinedPlanes planes = stages.extract();
  EXPECT_EQ (planes.coarse.size(), 0u);
  EXPECT_GE (planes.finer.planes.size(), 1u);
}

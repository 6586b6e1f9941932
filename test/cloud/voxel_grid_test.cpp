// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/voxel_grid.h"
#include "grid_scene.h"

using namespace pcl_ops::internal;

namespace {

double
countOf (const VoxelGrid& grid)
{
  double count = 0.0;
  for (const pcl_ops::Moments& voxel : grid.moments)
    count += voxel.count;
  return count;
}

} // namespace

TEST (VoxelGrid, SharesAVoxelBetweenPointsOfTheSameCubeOnly)
{
  Coordinates points;
  points.add (0.2f, 0.2f, 0.2f);
  points.add (-0.2f, 0.2f, 0.2f);
  points.add (0.8f, 0.8f, 0.8f);
  const VoxelGrid grid = voxelize (points, 1.0, 1);
  EXPECT_EQ (grid.size(), 2u);
  EXPECT_EQ (voxelsOfPoints (grid), (Indices{1, 0, 1}));
}

TEST (VoxelGrid, PutsPointsVoxelAfterVoxelInTheirOrder)
{
  const Coordinates points = pointsInACube (5000, 4.0);
  const VoxelGrid grid = voxelize (points, 0.5, 1);
  const std::uint32_t* next = grid.order->data();
  for (std::size_t voxel = 0; voxel < grid.size(); ++voxel) {
    const IndexRange here = grid.pointsOf (voxel);
    EXPECT_EQ (here.begin(), next);
    EXPECT_TRUE (std::is_sorted (here.begin(), here.end()));
    next = here.end();
  }
  EXPECT_EQ (next, grid.order->data() + 5000);
}

TEST (VoxelGrid, AddsUpTheMomentsOfTheVoxelsPoints)
{
  const Coordinates points = pointsInACube (5000, 4.0);
  const VoxelGrid grid = voxelize (points, 0.5, 1);
  const Indices voxels = voxelsOfPoints (grid);
  std::vector<pcl_ops::Moments> expected (grid.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    expected[voxels[i]].add (points.x[i], points.y[i], points.z[i]);
  for (std::size_t c = 0; c < expected.size(); ++c) {
    EXPECT_EQ (grid.moments[c].count, expected[c].count);
    EXPECT_LT ((grid.moments[c].sum - expected[c].sum).norm(), 1e-9);
  }
}

TEST (VoxelGrid, IsTheSameForAnyNumberOfThreads)
{
  const Coordinates points = pointsInACube (400000, 4.0);
  const VoxelGrid one = voxelize (points, 0.2, 1);
  for (const unsigned threads : {2u, 3u, 4u, 8u}) {
    const VoxelGrid many = voxelize (points, 0.2, threads);
    EXPECT_EQ (*one.order, *many.order);
    for (std::size_t c = 0; c < one.size(); ++c)
      ASSERT_EQ (one.moments[c].sum, many.moments[c].sum);
  }
}

TEST (CoarseVoxels, HoldsEightVoxelsEachAndLosesNoPoint)
{
  const VoxelGrid fine = voxelize (pointsInACube (3000, 4.0), 0.25, 1);
  const VoxelLevels levels = coarsen (fine);
  EXPECT_EQ (levels.coarse.voxel_size, 0.5);
  EXPECT_EQ (countOf (levels.coarse), countOf (fine));
  for (std::size_t c = 0; c < fine.size(); ++c) {
    const VoxelKey child = numbersOf (fine.codes[c]);
    const VoxelKey parent = numbersOf (levels.coarse.codes[levels.coarse_of_finest[c]]);
    EXPECT_EQ (parent.x, child.x >> 1);
    EXPECT_EQ (parent.z, child.z >> 1);
  }
}

TEST (CoarseVoxels, IsTheGridOfTwiceTheEdgeWhereverTheCloudBegins)
{
  for (const float shift : {0.0f, 0.25f, 0.5f, 0.75f}) {
    Coordinates points = pointsInACube (3000, 4.0);
    for (float& x : points.x)
      x += shift;
    const VoxelGrid coarser = coarsen (voxelize (points, 0.25, 1)).coarse;
    const VoxelGrid direct = voxelize (points, 0.5, 1);
    ASSERT_EQ (coarser.size(), direct.size());
    for (std::size_t c = 0; c < direct.size(); ++c)
      EXPECT_LT ((coarser.moments[c].sum - direct.moments[c].sum).norm(), 1e-9);
  }
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/voxel_grid.h"
#include "grid_scene.h"

using namespace pcl_ops::internal;

namespace {

/** \brief Number of points in all voxels. */
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
  const VoxelGrid grid = voxelize (points, 1.0, one_thread);
  EXPECT_EQ (grid.size(), 2u);
  EXPECT_EQ (voxelsOfPoints (grid), (Indices{1, 0, 1}));
}

TEST (VoxelGrid, PutsPointsVoxelAfterVoxelInTheirOrder)
{
  const Coordinates points = pointsInACube (5000, 4.0);
  const VoxelGrid grid = voxelize (points, 0.5, one_thread);
  const std::uint32_t* next = grid.order->data();
  for (std::size_t voxel = 0; voxel < grid.size(); ++voxel) {
    const IndexRange points_of_voxel = grid.pointsOf (voxel);
    EXPECT_EQ (points_of_voxel.begin(), next);
    EXPECT_TRUE (std::is_sorted (points_of_voxel.begin(), points_of_voxel.end()));
    next = points_of_voxel.end();
  }
  EXPECT_EQ (next, grid.order->data() + points.size());
}

TEST (VoxelGrid, AddsUpTheMomentsOfTheVoxelsPoints)
{
  const Coordinates points = pointsInACube (5000, 4.0);
  const VoxelGrid grid = voxelize (points, 0.5, one_thread);
  const Indices voxels = voxelsOfPoints (grid);
  std::vector<pcl_ops::Moments> expected (grid.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    expected[voxels[i]].add (points.x[i], points.y[i], points.z[i]);
  for (std::size_t voxel = 0; voxel < expected.size(); ++voxel) {
    EXPECT_EQ (grid.moments[voxel].count, expected[voxel].count);
    EXPECT_LT ((grid.moments[voxel].sum - expected[voxel].sum).norm(), 1e-9);
  }
}

TEST (VoxelGrid, IsTheSameForAnyNumberOfThreads)
{
  const Coordinates points = pointsInACube (400000, 4.0);
  const VoxelGrid by_one = voxelize (points, 0.2, one_thread);
  for (const unsigned threads : {2u, 3u, 4u, 8u}) {
    const VoxelGrid by_many = voxelize (points, 0.2, threads);
    EXPECT_EQ (*by_one.order, *by_many.order);
    ASSERT_EQ (by_one.codes, by_many.codes);
    for (std::size_t voxel = 0; voxel < by_one.size(); ++voxel)
      ASSERT_EQ (by_one.moments[voxel].sum, by_many.moments[voxel].sum);
  }
}

TEST (CoarseVoxels, HoldTheFineVoxelsInTheirCubeAndLoseNoPoint)
{
  const VoxelGrid fine = voxelize (pointsInACube (3000, 4.0), 0.25, one_thread);
  const VoxelLevels levels = coarsen (fine);
  EXPECT_EQ (levels.coarse.voxel_size, 0.5);
  EXPECT_EQ (countOf (levels.coarse), countOf (fine));
  for (std::size_t voxel = 0; voxel < fine.size(); ++voxel) {
    const VoxelKey child = shiftedKeyOf (fine.codes[voxel]);
    const VoxelKey parent =
        shiftedKeyOf (levels.coarse.codes[levels.coarse_of_finest[voxel]]);
    EXPECT_EQ (parent.x, child.x >> 1);
    EXPECT_EQ (parent.y, child.y >> 1);
    EXPECT_EQ (parent.z, child.z >> 1);
  }
}

TEST (CoarseVoxels, AreTheGridOfTwiceTheEdgeWhereverTheCloudBegins)
{
  for (const float shift : {0.0f, 0.25f, 0.5f, 0.75f}) {
    Coordinates points = pointsInACube (3000, 4.0);
    for (float& x : points.x)
      x += shift;
    const VoxelGrid coarser = coarsen (voxelize (points, 0.25, one_thread)).coarse;
    const VoxelGrid direct = voxelize (points, 0.5, one_thread);
    ASSERT_EQ (coarser.size(), direct.size());
    for (std::size_t voxel = 0; voxel < direct.size(); ++voxel)
      EXPECT_LT ((coarser.moments[voxel].sum - direct.moments[voxel].sum).norm(), 1e-9);
  }
}

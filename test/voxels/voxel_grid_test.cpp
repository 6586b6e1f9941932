// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "voxels/voxel_grid.h"

#include <numeric>

using namespace pcl_ops::internal;

namespace {

bool
isNeighbour (const VoxelKey& a, const VoxelKey& b)
{
  return std::abs (a.x - b.x) <= 1 && std::abs (a.y - b.y) <= 1 &&
         std::abs (a.z - b.z) <= 1;
}

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
  points.add (0.8f, 0.8f, 0.8f);
  points.add (-0.2f, 0.2f, 0.2f);
  const VoxelizedPoints voxelized = voxelize (points, 1.0, 1);
  EXPECT_EQ (voxelized.grid.size(), 2u);
  EXPECT_EQ (voxelized.voxel_of_point[0], voxelized.voxel_of_point[1]);
  EXPECT_NE (voxelized.voxel_of_point[0], voxelized.voxel_of_point[2]);
}

TEST (VoxelGrid, AddsUpTheMomentsOfTheVoxelsPoints)
{
  const Coordinates points = pointsInACube (5000, 4.0);
  const VoxelizedPoints voxelized = voxelize (points, 0.5, 1);
  std::vector<pcl_ops::Moments> expected (voxelized.grid.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    expected[voxelized.voxel_of_point[i]].add (points.x[i], points.y[i], points.z[i]);
  for (std::size_t c = 0; c < expected.size(); ++c) {
    EXPECT_EQ (voxelized.grid.moments[c].count, expected[c].count);
    EXPECT_LT ((voxelized.grid.moments[c].sum - expected[c].sum).norm(), 1e-9);
  }
}

TEST (VoxelGrid, KnowsEveryOccupiedNeighbourAsBruteForceDoes)
{
  const VoxelGrid grid = voxelize (pointsInACube (400, 9.0), 0.5, 1).grid;
  for (std::size_t a = 0; a < grid.size(); ++a) {
    std::vector<std::uint32_t> expected;
    for (std::size_t b = 0; b < grid.size(); ++b)
      if (isNeighbour (grid.keys[a], grid.keys[b]))
        expected.push_back (static_cast<std::uint32_t> (b));
    std::vector<std::uint32_t> found (grid.neighbours[a].begin(),
                                      grid.neighbours[a].end());
    std::sort (found.begin(), found.end());
    ASSERT_EQ (found, expected);
  }
}

TEST (VoxelGrid, IsTheSameForAnyNumberOfThreads)
{
  const Coordinates points = pointsInACube (400000, 4.0);
  const VoxelizedPoints one = voxelize (points, 0.2, 1);
  for (const unsigned threads : {2u, 3u, 4u, 8u}) {
    const VoxelizedPoints many = voxelize (points, 0.2, threads);
    EXPECT_EQ (one.voxel_of_point, many.voxel_of_point);
    for (std::size_t c = 0; c < one.grid.size(); ++c)
      ASSERT_EQ (one.grid.moments[c].sum, many.grid.moments[c].sum);
  }
}

TEST (VoxelGrid, KeepsStrayPointsFarAway)
{
  Coordinates points = pointsInACube (100, 1.0);
  points.add (1e9f, -1e9f, 1e9f);
  const VoxelizedPoints voxelized = voxelize (points, 0.1, 1);
  EXPECT_EQ (countOf (voxelized.grid), 101.0);
}

TEST (CoarserGrid, HoldsEightVoxelsEachAndLosesNoPoint)
{
  const VoxelGrid fine = voxelize (pointsInACube (3000, 4.0), 0.25, 1).grid;
  const CoarserGrid coarser = coarsen (fine, 1);
  EXPECT_EQ (coarser.grid.voxel_size, 0.5);
  EXPECT_EQ (countOf (coarser.grid), countOf (fine));
  for (std::size_t c = 0; c < fine.size(); ++c) {
    const VoxelKey& parent = coarser.grid.keys[coarser.voxel_of_finer[c]];
    EXPECT_EQ (parent.x, fine.keys[c].x >> 1);
    EXPECT_EQ (parent.z, fine.keys[c].z >> 1);
  }
}

TEST (VoxelSize, FillsAboutAsManyVoxelsAsWanted)
{
  Coordinates board, boards_far_apart;
  addGrid (board, {{0, 0, 0}, {5, 0, 0}, {0, 4, 0}}, 400);
  for (const double x : {0.0, 1000.0})
    addGrid (boards_far_apart, {{x, 0, 0}, {5, 0, 0}, {0, 4, 0}}, 400);
  for (const Coordinates& points : {board, boards_far_apart})
    for (const double wanted : {300.0, 2000.0, 10000.0}) {
      const double size = voxelSizeFor (points, wanted);
      const auto voxels = static_cast<double> (voxelize (points, size, 1).grid.size());
      EXPECT_NEAR (voxels / wanted, 1.0, 0.35) << wanted;
    }
}

TEST (VoxelSize, GrowsWithTheUnitOfTheCloud)
{
  Coordinates metres, millimetres;
  addGrid (metres, {{0, 0, 0}, {5, 0, 0}, {0, 4, 0}}, 200);
  addGrid (millimetres, {{0, 0, 0}, {5000, 0, 0}, {0, 4000, 0}}, 200);
  EXPECT_NEAR (voxelSizeFor (millimetres, 1000.0) / voxelSizeFor (metres, 1000.0),
               1000.0,
               100.0);
}

TEST (VoxelSize, DoesNotDependOnTheOrderOfThePoints)
{
  const Coordinates points = pointsInACube (50000, 4.0);
  Coordinates reversed;
  for (std::size_t i = points.size(); i-- > 0;)
    reversed.add (points.x[i], points.y[i], points.z[i]);
  EXPECT_EQ (voxelSizeFor (reversed, 1000.0), voxelSizeFor (points, 1000.0));
}

TEST (VoxelSize, IsZeroForPointsThatSpanNothing)
{
  Coordinates equal;
  EXPECT_EQ (voxelSizeFor (equal, 100.0), 0.0);
  equal.add (1.0f, 2.0f, 3.0f);
  equal.add (1.0f, 2.0f, 3.0f);
  EXPECT_EQ (voxelSizeFor (equal, 100.0), 0.0);
}

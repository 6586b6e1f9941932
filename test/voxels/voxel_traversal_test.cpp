// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "voxels/voxel_traversal.h"

using namespace pcl_ops::internal;

namespace {

/** \brief Tiles of 5 x 5 voxels of 10 cm, a metre apart. */
VoxelGrid
twoTiles ()
{
  Coordinates points;
  addGrid (points, {{0, 0, 0.05}, {0.5, 0, 0}, {0, 0.5, 0}}, 20);
  addGrid (points, {{1.5, 0, 0.05}, {0.5, 0, 0}, {0, 0.5, 0}}, 20);
  return voxelize (points, 10_cm, 1).grid;
}

} // namespace

TEST (ForVoxels, VisitsEachOnceForAnyNumberOfThreads)
{
  const VoxelGrid grid = twoTiles();
  for (const unsigned threads : {1u, 4u}) {
    std::vector<int> visits (grid.size(), 0);
    forVoxels (grid, threads, [&] (std::size_t voxel) { ++visits[voxel]; });
    EXPECT_EQ (visits, std::vector<int> (50, 1));
  }
}

TEST (ConnectedVoxels, AreAllThatCanBeReached)
{
  const VoxelGrid grid = twoTiles();
  std::vector<char> is_open (grid.size(), 1);
  const Indices tile = connectedVoxels (grid, 0, [&] (std::uint32_t voxel) {
    return std::exchange (is_open[voxel], 0) != 0;
  });
  EXPECT_EQ (tile.size(), 25u);
  const bool is_left = grid.moments[0].centroid().x() < 1.0;
  for (const std::uint32_t voxel : tile)
    EXPECT_EQ (grid.moments[voxel].centroid().x() < 1.0, is_left);
}

TEST (ConnectedVoxels, AreNoneWhereTheFirstIsNotTaken)
{
  EXPECT_TRUE (
      connectedVoxels (twoTiles(), 0, [] (std::uint32_t) { return false; }).empty());
}

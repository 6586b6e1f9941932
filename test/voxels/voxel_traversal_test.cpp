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
  return connectedGrid (points, 10_cm);
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

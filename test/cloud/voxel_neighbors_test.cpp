// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/voxel_neighbors.h"
#include "grid_scene.h"

using namespace pcl_ops::internal;

namespace {

/** \brief Whether two voxels touch, also at a corner, or are the same. */
bool
isNeighbor (const VoxelKey& a, const VoxelKey& b)
{
  return std::abs (a.x - b.x) <= 1 && std::abs (a.y - b.y) <= 1 &&
         std::abs (a.z - b.z) <= 1;
}

} // namespace

TEST (VoxelNeighbors, AreThoseThatBruteForceFinds)
{
  // Some of the small voxels touch another occupied voxel; nearly all of the large ones
  // touch several.
  for (const double edge : {0.2, 0.5, 1.5}) {
    const VoxelGrid grid = voxelize (pointsInACube (400, 9.0), edge, one_thread);
    const VoxelNeighbors neighbors = connected (grid.codes, one_thread).neighbors;
    ASSERT_EQ (neighbors.occupied.size(), grid.size());
    for (std::size_t a = 0; a < grid.size(); ++a) {
      Indices expected;
      for (std::size_t b = 0; b < grid.size(); ++b)
        if (isNeighbor (shiftedKeyOf (grid.codes[a]), shiftedKeyOf (grid.codes[b])))
          expected.push_back (static_cast<std::uint32_t> (b));
      Indices found (neighbors[a].begin(), neighbors[a].end());
      std::sort (found.begin(), found.end());
      ASSERT_EQ (found, expected);
    }
  }
}

TEST (VoxelNeighbors, ReachAcrossTheBordersOfAllLargerVoxels)
{
  // Two voxels that touch at the middle of the range of Morton codes, 20 bits per axis:
  // a key plus key_offset is 2^19 there, and larger voxels of every level have a
  // border.
  const std::int32_t middle = (1 << 19) - key_offset;
  const std::vector<MortonCode> codes{mortonCode (middle - 1, middle - 1, middle - 1),
                                      mortonCode (middle, middle, middle)};
  const VoxelNeighbors neighbors = connected (codes, one_thread).neighbors;
  for (const std::size_t voxel : {0, 1})
    EXPECT_EQ (Indices (neighbors[voxel].begin(), neighbors[voxel].end()),
               (Indices{0, 1}));
}

TEST (VoxelNeighbors, OfOneVoxelAreItself)
{
  for (const MortonCode code : {MortonCode (0), mortonCode (5, -6, 7)}) {
    const VoxelNeighbors neighbors = connected ({code}, one_thread).neighbors;
    ASSERT_EQ (neighbors.occupied.size(), 1u);
    EXPECT_EQ (Indices (neighbors[0].begin(), neighbors[0].end()), (Indices{0}));
  }
  EXPECT_EQ (connected ({}, one_thread).neighbors.occupied.size(), 0u);
}

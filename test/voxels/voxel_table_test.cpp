// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "voxels/voxel_table.h"

#include <set>

using namespace pcl_ops::internal;

namespace {

constexpr std::int32_t zero = 1 << 20; // keys are shifted above zero

VoxelKey
at (int x, int y, int z)
{
  return {zero + x, zero + y, zero + z};
}

std::set<std::uint32_t>
setOf (const VoxelRange& range)
{
  return {range.begin(), range.end()};
}

} // namespace

TEST (VoxelTable, NumbersVoxelsAsTheyComeAndKnowsThemAgain)
{
  VoxelTable table;
  EXPECT_EQ (table.insert (at (0, 0, 0)), 0u);
  EXPECT_EQ (table.insert (at (100, 0, 0)), 1u);
  EXPECT_EQ (table.insert (at (0, 0, 0)), 0u);
  EXPECT_EQ (table.size(), 2u);
}

TEST (VoxelTable, HoldsMoreBlocksThanItBeganWith)
{
  VoxelTable table;
  for (int i = 0; i < 5000; ++i)
    EXPECT_EQ (table.insert (at (8 * i, 0, 0)), static_cast<std::uint32_t> (i));
  for (int i = 0; i < 5000; ++i)
    EXPECT_EQ (table.insert (at (8 * i, 0, 0)), static_cast<std::uint32_t> (i));
}

TEST (VoxelTable, SortsByCoordinatesWhateverTheOrderVoxelsCameIn)
{
  VoxelTable forwards, backwards;
  for (int i = 0; i < 100; ++i) {
    forwards.insert (at (3 * i, 0, 0));
    backwards.insert (at (3 * (99 - i), 0, 0));
  }
  forwards.sort();
  const std::vector<std::uint32_t> place = backwards.sort();
  for (std::uint32_t i = 0; i < 100; ++i) {
    EXPECT_EQ (forwards.keys()[i].x, backwards.keys()[i].x);
    EXPECT_EQ (backwards.keys()[place[i]].x, zero + 3 * (99 - static_cast<int> (i)));
  }
}

TEST (VoxelTable, KnowsNeighboursAcrossBlocksAndCorners)
{
  VoxelTable table;
  for (const VoxelKey& key : {at (7, 7, 7), at (8, 8, 8), at (8, 7, 7), at (9, 9, 9)})
    table.insert (key); // blocks are 8 voxels wide
  const std::vector<std::uint32_t> place = table.sort();
  const VoxelNeighbours neighbours = table.neighbours (1);
  ASSERT_EQ (neighbours.size(), 4u);
  EXPECT_EQ (setOf (neighbours[place[0]]),
             (std::set<std::uint32_t>{place[0], place[1], place[2]}));
  EXPECT_EQ (setOf (neighbours[place[3]]),
             (std::set<std::uint32_t>{place[1], place[3]}));
}

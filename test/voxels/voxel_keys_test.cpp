// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "voxels/voxel_keys.h"

#include <limits>

using namespace pcl_ops::internal;

namespace {

constexpr std::int32_t zero = 1 << 20; // keys are shifted above zero

std::int32_t
keyOf (float coordinate, float voxels_per_metre = 10.0f)
{
  std::int32_t key = 0;
  keysOf (&coordinate, 1, voxels_per_metre, &key);
  return key;
}

struct Stretch {
  std::size_t first, last;
  std::int32_t x;

  bool
  operator== (const Stretch& other) const
  {
    return first == other.first && last == other.last && x == other.x;
  }
};

std::vector<Stretch>
runsOf (const std::vector<float>& along_x, std::size_t begin, std::size_t end)
{
  Coordinates points;
  for (const float x : along_x)
    points.add (x, 0.0f, 0.0f);
  std::vector<Stretch> runs;
  forRuns (
      points, 1.0, begin, end, [&] (std::size_t first, std::size_t last, VoxelKey key) {
        runs.push_back ({first, last, key.x - zero});
      });
  return runs;
}

} // namespace

TEST (VoxelKeys, AreRoundedDown)
{
  EXPECT_EQ (keyOf (0.05f), zero);
  EXPECT_EQ (keyOf (0.15f), zero + 1);
  EXPECT_EQ (keyOf (-0.05f), zero - 1);
  EXPECT_EQ (keyOf (-0.1f, 10.0f), zero - 1) << "a whole number stays";
}

TEST (VoxelKeys, EndWhereTheirRangeEnds)
{
  EXPECT_EQ (keyOf (1e9f), zero + zero - 1);
  EXPECT_EQ (keyOf (-1e9f), 1);
}

TEST (VoxelKeys, OfVoxelsTooSmallForTheirInverseAreInTheirRange)
{
  // 0 times infinity is no number.
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ (keyOf (0.0f, infinite), keyOf (-1.0f, infinite));
}

TEST (VoxelKeys, ComeInRunsOfPointsOfTheSameVoxel)
{
  EXPECT_EQ (runsOf ({0.1f, 0.9f, 5.5f, 0.2f}, 0, 4),
             (std::vector<Stretch>{{0, 2, 0}, {2, 3, 5}, {3, 4, 0}}));
  EXPECT_EQ (runsOf ({0.1f, 0.9f, 5.5f, 0.2f}, 1, 3),
             (std::vector<Stretch>{{1, 2, 0}, {2, 3, 5}}));
}

TEST (VoxelKeys, ComeInRunsThatCoverEveryPointOnce)
{
  std::size_t next = 0;
  for (const Stretch& run : runsOf (std::vector<float> (2000, 0.5f), 0, 2000)) {
    EXPECT_EQ (run.first, next);
    next = run.last;
  }
  EXPECT_EQ (next, 2000u);
}

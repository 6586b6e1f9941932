// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "voxels/morton_code.h"

#include <limits>

using namespace pcl_ops::internal;

namespace {

std::int32_t
keyOfCoordinate (float coordinate, float voxels_per_metre = 10.0f)
{
  std::int32_t key = 0;
  keysOf (&coordinate, 1, voxels_per_metre, &key);
  return key;
}

} // namespace

TEST (VoxelKeys, AreRoundedDown)
{
  EXPECT_EQ (keyOfCoordinate (0.05f), 0);
  EXPECT_EQ (keyOfCoordinate (0.15f), 1);
  EXPECT_EQ (keyOfCoordinate (-0.05f), -1);
  EXPECT_EQ (keyOfCoordinate (-0.1f), -1) << "a whole number stays";
}

TEST (VoxelKeys, EndWhereTheirRangeEnds)
{
  EXPECT_EQ (keyOfCoordinate (1e9f), (1 << 20) - 1);
  EXPECT_EQ (keyOfCoordinate (-1e9f), -(1 << 20) + 1);
}

TEST (VoxelKeys, OfVoxelsTooSmallForTheirInverseAreInTheirRange)
{
  // 0 times infinity is no number.
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ (keyOfCoordinate (0.0f, infinite), keyOfCoordinate (-1.0f, infinite));
}

TEST (MortonCode, InterleavesTheBitsOfCoordinates)
{
  EXPECT_EQ (mortonCode (1, 0, 0), 1u);
  EXPECT_EQ (mortonCode (0, 1, 0), 2u);
  EXPECT_EQ (mortonCode (0, 0, 1), 4u);
  EXPECT_EQ (mortonCode (0b101, 0b010, 0b111), 0b101110101u);
}

TEST (MortonCode, OfTheVoxelOfTwiceTheEdgeIsAnEighth)
{
  EXPECT_EQ (mortonCode (11, 22, 33) >> 3, mortonCode (5, 11, 16));
}

TEST (MortonCode, TellsTheCoordinatesAgain)
{
  constexpr std::uint32_t largest = (1u << 21) - 1;
  for (const std::uint32_t x : {0u, 1u, 0x12345u, largest}) {
    const VoxelKey key = keyOf (mortonCode (x, largest - x, 7));
    EXPECT_EQ (key.x, static_cast<std::int32_t> (x));
    EXPECT_EQ (key.y, static_cast<std::int32_t> (largest - x));
    EXPECT_EQ (key.z, 7);
  }
}

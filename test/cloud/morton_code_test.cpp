// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cloud/morton_code.h"

#include <limits>

using namespace pcl_ops::internal;

namespace {

/** \brief The voxel key of a coordinate [m]: how many voxels it is from zero, rounded
 * down. */
std::int32_t
keyOfCoordinate (float coordinate, float voxels_per_meter = 10.0f)
{
  std::int32_t key = 0;
  keysOf (&coordinate, 1, voxels_per_meter, &key);
  return key;
}

} // namespace

TEST (VoxelKeys, AreRoundedDownAndClampedToTheirRange)
{
  EXPECT_EQ (keyOfCoordinate (0.05f), 0);
  EXPECT_EQ (keyOfCoordinate (0.15f), 1);
  EXPECT_EQ (keyOfCoordinate (-0.05f), -1);
  EXPECT_EQ (keyOfCoordinate (-0.1f), -1) << "a whole number stays";
  EXPECT_EQ (keyOfCoordinate (1e9f), key_limit);
  EXPECT_EQ (keyOfCoordinate (-1e9f), -key_limit);
}

TEST (VoxelKeys, AreAtTheEndsOfTheirRangeWhereTheInverseOfTheEdgeIsInfinite)
{
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ (keyOfCoordinate (1.0f, infinite), key_limit);
  EXPECT_EQ (keyOfCoordinate (-1.0f, infinite), -key_limit);
  EXPECT_EQ (keyOfCoordinate (0.0f, infinite), -key_limit) << "0 times infinity is NaN";
}

TEST (MortonCode, InterleavesTheBitsOfCoordinates)
{
  EXPECT_EQ (mortonCode (1, 0, 0) - mortonCode (0, 0, 0), 1u);
  EXPECT_EQ (mortonCode (0, 1, 0) - mortonCode (0, 0, 0), 2u);
  EXPECT_EQ (mortonCode (0, 0, 1) - mortonCode (0, 0, 0), 4u);
  EXPECT_EQ (mortonCode (0b101, 0b010, 0b111) - mortonCode (0, 0, 0), 0b101110101u);
}

TEST (MortonCode, WithoutItsLast3BitsIsTheCodeOfAVoxelOfTwiceTheEdge)
{
  EXPECT_EQ (mortonCode (10, 22, 32) >> 3, mortonCode (11, 23, 33) >> 3);
  EXPECT_NE (mortonCode (10, 22, 32) >> 3, mortonCode (9, 22, 32) >> 3);
}

TEST (MortonCode, WithoutItsLast30BitsIsTheCodeOfAVoxelOf1024TimesTheEdge)
{
  EXPECT_EQ (mortonCode (0, 0, 0) >> 30, mortonCode (1023, 1023, 1023) >> 30);
  EXPECT_NE (mortonCode (0, 0, 0) >> 30, mortonCode (-1, 0, 0) >> 30);
}

TEST (MortonCode, GivesTheCoordinatesBackPlusTheirOffset)
{
  for (const std::int32_t x : {0, 1, 0x12345, key_limit, -key_limit}) {
    const VoxelKey key = shiftedKeyOf (mortonCode (x, -x, 7));
    EXPECT_EQ (key.x, key_offset + x);
    EXPECT_EQ (key.y, key_offset - x);
    EXPECT_EQ (key.z, key_offset + 7);
  }
}

TEST (MortonCode, OfKeysNearZeroSharesItsUpperBits)
{
  // Keys from -100 to 100 differ in the lowest 11 bits of each of the three
  // coordinates.
  for (const std::int32_t x : {-100, 0, 100})
    EXPECT_EQ (mortonCode (x, -x, x) >> 33, mortonCode (0, 0, 0) >> 33);
}

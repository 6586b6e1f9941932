// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "ops/voxel_choice.h"

using namespace pcl_ops::internal;

namespace {

// 100,000 points in some 420 voxels, of 20 cm.
constexpr int many = 224;
constexpr double few_voxels = 0.003;

/** \brief Of a floor of 40 m, 10,000 points, with a patch of 2 m in it, as many, with
 * so much noise; in some 270 voxels of 2.5 m if both were as dense. */
VoxelGrid
gridOfUnevenFloor (double noise)
{
  Points points;
  for (const double height : {-noise, noise}) {
    addGrid (points, {{-20, -20, height}, {40, 0, 0}, {0, 40, 0}}, 71);
    addGrid (points, {{-1, -1, height}, {2, 0, 0}, {0, 2, 0}}, 71);
  }
  return voxelizeByNoise (points, few_voxels, 1).grid;
}

/** \brief Of two floors of 4 m, so far above each other. */
VoxelGrid
gridOfFloors (double apart, int steps, double sampling_rate)
{
  Points points;
  for (const double height : {0.0, apart})
    addGrid (points, {{-2, -2, height}, {4, 0, 0}, {0, 4, 0}}, steps);
  return voxelizeByNoise (points, sampling_rate, 1).grid;
}

} // namespace

TEST (VoxelChoice, TakesSmallVoxelsOfManyPointsWithoutNoise)
{
  const VoxelGrid noisy = gridOfFloors (4_cm, many, few_voxels);
  const VoxelGrid exact = gridOfFloors (0.0, many, few_voxels);
  EXPECT_LT (exact.voxel_size, 0.6 * noisy.voxel_size);
}

TEST (VoxelChoice, LeavesPointsEnoughInAVoxel)
{
  // Of exact planes and of those with hardly any noise, which would do with 36 mm.
  for (const double apart : {0.0, 1_mm})
    EXPECT_GT (meanPointsPerVoxel (gridOfFloors (apart, many, few_voxels)), 8.0);
}

TEST (VoxelChoice, TakesLargerVoxelsForFewerSamples)
{
  EXPECT_GT (gridOfFloors (4_cm, many, few_voxels).voxel_size,
             1.5 * gridOfFloors (4_cm, many, 3.0 * few_voxels).voxel_size);
}

TEST (VoxelChoice, SuitsTheDensePlacesOfACloud)
{
  // Half of the points are on a patch of 2 m, as in a scan of a lidar.
  EXPECT_LT (gridOfUnevenFloor (0.0).voxel_size, 50_cm);
}

TEST (VoxelChoice, LeavesNoisyDensePlacesTheVoxelsTheyNeed)
{
  EXPECT_GT (gridOfUnevenFloor (5_cm).voxel_size,
             2.0 * gridOfUnevenFloor (0.0).voxel_size);
}

TEST (VoxelChoice, HasVoxelsForAllOfACloudThatIsMostlyAtOnePlace)
{
  // A floor of 40 m, in voxels of some 2 m, and half as many points on a square
  // millimetre of it.
  Points points;
  addGrid (points, {{-20, -20, 0}, {40, 0, 0}, {0, 40, 0}}, 300);
  addGrid (points, {{0, 0, 0}, {1_mm, 0, 0}, {0, 1_mm, 0}}, 200);
  const VoxelGrid grid = voxelizeByNoise (points, few_voxels, 1).grid;
  EXPECT_GT (grid.voxel_size, 10_cm);
}

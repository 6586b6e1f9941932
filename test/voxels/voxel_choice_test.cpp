// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "voxels/voxel_choice.h"
#include <pcl_ops/voxel_size.h>

using namespace pcl_ops::internal;

namespace {

/** \brief Steps of the grid on each of two floors of 4 m x 4 m: 100,000 points. */
constexpr int many_steps = 224;
constexpr double default_rate = 0.03;
/** \brief A sampling rate by which the points of both floors are in some 420 voxels of
 * 20 cm if only their number decides. */
constexpr double low_rate = 0.003;

/** \brief Voxels of a floor of 40 m x 40 m with 40,000 points, some 12 in a voxel,
 * and 10,000 more points on a square patch of it. Half of the points lie \p noise [m]
 * above the floor and half as far below.
 * \param[in] patch_edge [m] */
VoxelGrid
gridOfFloorWithPatch (double patch_edge, double noise)
{
  constexpr int floor_steps = 141, patch_steps = 70; // at each of two heights
  const double corner = -0.5 * patch_edge;
  Points points;
  // The floor is at 15 cm, not at zero, where voxels begin: both heights are in one
  // voxel.
  for (const double height : {15_cm - noise, 15_cm + noise}) {
    addGrid (points, {{-20, -20, height}, {40, 0, 0}, {0, 40, 0}}, floor_steps);
    addGrid (points,
             {{corner, corner, height}, {patch_edge, 0, 0}, {0, patch_edge, 0}},
             patch_steps);
  }
  return voxelizeByNoise (points, default_rate, one_thread).coarse;
}

/** \brief Voxels of a floor of 4 m x 4 m whose half with x > 0 has two layers, as two
 * steps of a quantized depth.
 * \param[in] apart distance of the layers [m] */
VoxelGrid
gridOfFloorWithHalfInTwoLayers (double apart)
{
  const Points points = gridsOf ({{{-2, -2, 0}, {2, 0, 0}, {0, 4, 0}},
                                  {{0, -2, 0}, {2, 0, 0}, {0, 4, 0}},
                                  {{0, -2, apart}, {2, 0, 0}, {0, 4, 0}}},
                                 many_steps);
  return voxelizeByNoise (points, low_rate, one_thread).coarse;
}

/** \brief Voxels of two floors of 4 m x 4 m, one above the other, with steps x steps
 * points each.
 * \param[in] apart distance of the floors [m]; half is their noise as one floor */
VoxelGrid
gridOfFloors (double apart, int steps, double sampling_rate)
{
  const Points points = gridsOf (
      {{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}, {{-2, -2, apart}, {4, 0, 0}, {0, 4, 0}}},
      steps);
  return voxelizeByNoise (points, sampling_rate, one_thread).coarse;
}

} // namespace

TEST (VoxelChoice, TakesSmallVoxelsOfManyPointsWithoutNoise)
{
  const VoxelGrid noisy = gridOfFloors (4_cm, many_steps, low_rate);
  const VoxelGrid exact = gridOfFloors (0.0, many_steps, low_rate);
  EXPECT_LT (exact.voxel_size, 0.6 * noisy.voxel_size);
}

TEST (VoxelChoice, TakesVoxelsOfSeventyTimesTheNoise)
{
  // The floors are 2.8 mm apart: one floor with a noise of 1.4 mm. Voxels of 70 times
  // that, 10 cm, still have points enough.
  EXPECT_NEAR (gridOfFloors (0.0028, many_steps, low_rate).voxel_size, 10_cm, 1_cm);
}

TEST (VoxelChoice, FollowsTheNoiseOfTheLeastNoisyQuarterOfTheVoxels)
{
  // A floor of 16 squares of 1 m x 1 m with points at two heights: 2.8 mm apart, but
  // only 1.4 mm on so many quiet squares.
  const auto voxelSizeWith = [] (int quiet_squares) {
    constexpr int steps = 56;
    Points points;
    for (const int x : {0, 1, 2, 3})
      for (const int y : {0, 1, 2, 3}) {
        const double apart = 4 * x + y < quiet_squares ? 0.0014 : 0.0028;
        addGrid (points, {{x - 2.0, y - 2.0, 0}, {1, 0, 0}, {0, 1, 0}}, steps);
        addGrid (points, {{x - 2.0, y - 2.0, apart}, {1, 0, 0}, {0, 1, 0}}, steps);
      }
    return voxelizeByNoise (points, low_rate, one_thread).coarse.voxel_size;
  };
  EXPECT_NEAR (voxelSizeWith (3), 10_cm, 1_cm) << "19 %";
  EXPECT_LT (voxelSizeWith (6), 7_cm) << "38 %";
}

TEST (VoxelChoice, LeavesPointsEnoughInAVoxel)
{
  // An exact floor, and one with a noise of 0.5 mm, which alone would allow voxels of
  // 36 mm.
  for (const double apart : {0.0, 1_mm})
    EXPECT_GT (meanPointsPerVoxel (gridOfFloors (apart, many_steps, low_rate)), 8.0);
  constexpr int few_steps = 23;
  EXPECT_GT (meanPointsPerVoxel (gridOfFloors (4_cm, few_steps, default_rate)), 3.0)
      << "a small cloud";
}

TEST (VoxelChoice, LeavesNoMorePointsInAVoxelThanEnoughOnAnExactFloor)
{
  EXPECT_LT (meanPointsPerVoxel (gridOfFloors (0.0, many_steps, low_rate)), 20.0);
  constexpr int few_steps = 23;
  EXPECT_LT (meanPointsPerVoxel (gridOfFloors (4_cm, few_steps, default_rate)), 9.0)
      << "a small cloud";
}

TEST (VoxelSizeFor, TwoPointsIsPositiveAndAtMostTheirDistance)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.push_back ({-4, 0, 0});
  cloud.push_back ({4, 0, 0});
  constexpr double wanted_voxels = 2.0;
  const double size = pcl_ops::voxelSizeFor (pcl_ops::CloudView (cloud), wanted_voxels);
  EXPECT_GT (size, 0.0);
  EXPECT_LE (size, 8.0);
}

TEST (VoxelChoice, IsLargerThanTheStepsOfSinglePrecision)
{
  Points points = gridsOf ({{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}}, many_steps);
  points.origin = {0.0, 1e6, 0.0}; // a step is 6.25 cm; voxels have 16 steps or more
  const double size = voxelizeByNoise (points, low_rate, one_thread).coarse.voxel_size;
  EXPECT_GE (size, 1_m);
  EXPECT_LT (size, 1.5_m) << "no more than needed";
}

TEST (VoxelChoice, TakesLargerVoxelsForFewerSamples)
{
  EXPECT_GT (gridOfFloors (4_cm, many_steps, low_rate).voxel_size,
             1.5 * gridOfFloors (4_cm, many_steps, 3.0 * low_rate).voxel_size);
}

TEST (VoxelChoice, SuitsTheDensePlacesOfACloudUnlessTheyAreNoisy)
{
  // A dense patch, as near a lidar. A patch of 40 m covers the whole floor: then the
  // density is even.
  const double exact = gridOfFloorWithPatch (4_m, 0.0).voxel_size;
  EXPECT_LT (exact, 0.6 * gridOfFloorWithPatch (40_m, 0.0).voxel_size);
  EXPECT_GT (gridOfFloorWithPatch (4_m, 5_cm).voxel_size, 1.5 * exact);
}

TEST (VoxelChoice, TakesLargerVoxelsWhereHalfOfTheFloorIsInTwoStepsOfAQuantizedDepth)
{
  EXPECT_GT (gridOfFloorWithHalfInTwoLayers (4_cm).voxel_size,
             1.5 * gridOfFloorWithHalfInTwoLayers (0.0).voxel_size);
}

TEST (VoxelChoice, HasVoxelsForAllOfACloudThatIsMostlyAtOnePlace)
{
  // A floor of 40 m x 40 m with 90,000 points, in voxels of some 2 m, and 40,000 more
  // points on a square millimeter of it. Voxels shrink to no less than 1/16, 12 cm.
  constexpr int floor_steps = 300, dense_steps = 200;
  Points points;
  addGrid (points, {{-20, -20, 0}, {40, 0, 0}, {0, 40, 0}}, floor_steps);
  addGrid (points, {{0, 0, 0}, {1_mm, 0, 0}, {0, 1_mm, 0}}, dense_steps);
  const VoxelGrid grid = voxelizeByNoise (points, low_rate, one_thread).coarse;
  EXPECT_GT (grid.voxel_size, 10_cm);
}

TEST (WantedVoxels, AreTwoThirdsOfTheSamplesOf300000Points)
{
  const double samples = 0.03 * 300'000;
  EXPECT_NEAR (wantedVoxels (300'000, 0.03, 1.0), 2.0 / 3.0 * samples, 0.3 * samples);
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/voxel_size.h"
#include "grid_scene.h"

#include <map>

using namespace pcl_ops::internal;

TEST (VoxelSize, FillsAboutAsManyVoxelsAsWanted)
{
  const Surface board{{0, 0, 0}, {5, 0, 0}, {0, 4, 0}};
  const Surface board_far_away{{1000, 0, 0}, {5, 0, 0}, {0, 4, 0}};
  for (const Coordinates& points :
       {gridsOf ({board}, 400), gridsOf ({board, board_far_away}, 400)})
    for (const double wanted : {300.0, 2000.0, 10000.0}) {
      const double size = voxelSizeFor (points, wanted);
      const auto voxels =
          static_cast<double> (voxelize (points, size, one_thread).size());
      // Rounding the edge changes their number by up to 21 %, from 5.5 to 5; the rest
      // is the error of a sample.
      EXPECT_NEAR (voxels / wanted, 1.0, 0.35) << wanted;
    }
}

TEST (VoxelSize, IsProportionalToTheCoordinates)
{
  const Coordinates meters = gridsOf ({{{0, 0, 0}, {5, 0, 0}, {0, 4, 0}}}, 200);
  const Coordinates millimeters =
      gridsOf ({{{0, 0, 0}, {5000, 0, 0}, {0, 4000, 0}}}, 200);
  // Some 14 cm and 140 mm. Each estimate has its own sample, so that it may be rounded
  // to the step beside that of the other: 13 cm or 15 cm, 7 % less or more.
  EXPECT_NEAR (voxelSizeFor (millimeters, 1000.0) / voxelSizeFor (meters, 1000.0),
               1000.0,
               100.0);
}

TEST (VoxelSize, IsTheSameInAnyOrderOfPointsAndForCoordinatesRoundedOtherwise)
{
  const Coordinates points = pointsInACube (50000, 4.0);
  Coordinates reversed;
  Coordinates rounded_otherwise = points;
  for (std::size_t i = points.size(); i-- > 0;)
    reversed.add (points.x[i], points.y[i], points.z[i]);
  for (float& x : rounded_otherwise.x)
    x += 1e-6f;
  for (double wanted = 500.0; wanted < 1500.0; wanted += 100.0) {
    const double size = voxelSizeFor (points, wanted);
    EXPECT_GT (size, 0.0);
    for (const Coordinates& others : {reversed, rounded_otherwise})
      EXPECT_EQ (voxelSizeFor (others, wanted), size);
  }
}

TEST (RoundNumber, IsTheNearestMultipleOfAStepThatGrowsWithIt)
{
  // Steps of 0.1 from 1 to 2, of 0.25 from 2 to 5 and of 1 from 5 to 10, and these
  // times powers of 10.
  for (const auto& [size, expected] : std::map<double, double>{{0.0104, 0.01},
                                                               {0.0512, 0.05},
                                                               {0.057, 0.06},
                                                               {1.06, 1.1},
                                                               {2.1, 2.0},
                                                               {3.9, 4.0},
                                                               {9.7, 10.0},
                                                               {730.0, 700.0}}) {
    EXPECT_DOUBLE_EQ (roundNumber (size), expected);
    EXPECT_NEAR (roundNumber (1000.0 * size) / expected, 1000.0, 1e-9);
  }
}

TEST (VoxelSize, IsZeroForPointsThatSpanNothing)
{
  Coordinates equal;
  for (int number = 0; number < 3; ++number) {
    EXPECT_EQ (voxelSizeFor (equal, 100.0), 0.0);
    equal.add (1.0f, 2.0f, 3.0f);
  }
}

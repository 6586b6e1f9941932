// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/noise_floors.h"
#include "bounded/noise_measurement.h"
#include "voxel_scene.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief Rms distance of points that are spread evenly within a noise. */
double
rmsOf (double noise)
{
  return noise / std::sqrt (3.0);
}

} // namespace

TEST (Noise, IsTheInnerOneWhereAPlaneMeetsAnother)
{
  // A voxel of the common row holds points up to 5 cm off the plane it is on.
  VoxelScene scene ({{ground}, {wall}}, 1_cm);
  measureNoise (scene.grid(), 1, scene.planes);
  ASSERT_FALSE (scene.planes.noise.empty());
  for (const double noise : scene.planes.noise)
    EXPECT_NEAR (noise, rmsOf (1_cm), 1_mm);
}

TEST (Noise, IsThatOfTheOwnPlanesVoxelsAlone)
{
  // Two halves of a ground, the plane of the right one 4 cm off its points.
  VoxelScene scene ({{ground}, {{{2, 0, 0.05}, {2, 0, 0}, {0, 2, 0}}}});
  scene.planes.planes[1].offset += 4_cm;
  measureNoise (scene.grid(), 1, scene.planes);
  EXPECT_NEAR (scene.planes.noise.at (0), smallestNoise (scene.grid()), 1e-6);
  EXPECT_NEAR (scene.planes.noise.at (1), 4_cm, 1e-6);
}

TEST (Noise, OfAPlaneWithoutInnerVoxelsIsThatOfAllOfThem)
{
  // Two strips of one row each, so that every voxel has one of the other beside it.
  VoxelScene scene ({{{{0, 0, 0.05}, {2, 0, 0}, {0, 0.1, 0}}},
                     {{{0, 0.1, 0.05}, {2, 0, 0}, {0, 0.1, 0}}}},
                    2_cm);
  scene.planes.noise.clear();
  measureNoise (scene.grid(), 1, scene.planes);
  ASSERT_FALSE (scene.planes.noise.empty());
  for (const double noise : scene.planes.noise)
    EXPECT_NEAR (noise, rmsOf (2_cm), 2_mm);
}

TEST (Noise, FloorsFollowTheVoxelSize)
{
  VoxelGrid grid;
  grid.voxel_size = 10_cm;
  EXPECT_DOUBLE_EQ (smallestNoise (grid), 3_mm);
  EXPECT_DOUBLE_EQ (smallestBand (grid, 1_m), 2_cm);
  EXPECT_DOUBLE_EQ (smallestBand (grid, 1_cm), 1_cm) << "never above theta_h";
}

TEST (Noise, OfAPlaneWithoutVoxelsIsKept)
{
  VoxelScene scene ({{ground}}, 1_cm);
  scene.addPlane ({Eigen::Vector3d::UnitX(), 7.0});
  scene.planes.noise[1] = 1_m;
  measureNoise (scene.grid(), 1, scene.planes);
  EXPECT_NEAR (scene.planes.noise[0], rmsOf (1_cm), 1_mm);
  EXPECT_EQ (scene.planes.noise[1], 1_m);
}

TEST (Noise, IsThatOfMostOfThePlane)
{
  // A tenth of the ground lies under a carpet of 3 cm.
  VoxelScene scene ({{{{0, 0, 0.05}, {1.8, 0, 0}, {0, 2, 0}},
                      {{1.8, 0, 0.08}, {0.2, 0, 0}, {0, 2, 0}}}},
                    1_cm);
  measureNoise (scene.grid(), 1, scene.planes);
  EXPECT_NEAR (scene.planes.noise[0], rmsOf (1_cm), 1_mm);
}

TEST (Noise, IsThatOfInnerVoxelsHoweverFewTheyAre)
{
  // A ground that is uneven by 3 cm but for its middle; over all the rest, a lid.
  const auto ringAt = [] (double z) {
    return std::vector<Surface>{{{0, 0, z}, {0.7, 0, 0}, {0, 2, 0}},
                                {{1.3, 0, z}, {0.7, 0, 0}, {0, 2, 0}},
                                {{0.7, 0, z}, {0.6, 0, 0}, {0, 0.7, 0}},
                                {{0.7, 1.3, z}, {0.6, 0, 0}, {0, 0.7, 0}}};
  };
  std::vector<Surface> uneven = ringAt (0.08);
  uneven.insert (uneven.begin(), {{0.7, 0.7, 0.05}, {0.6, 0, 0}, {0, 0.6, 0}});
  VoxelScene scene ({uneven, ringAt (0.15)});
  measureNoise (scene.grid(), 1, scene.planes);
  EXPECT_NEAR (scene.planes.noise[0], smallestNoise (scene.grid()), 1e-6);
}

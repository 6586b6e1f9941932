// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/noise_floors.h"
#include "bounded/noise_measurement.h"
#include "voxel_scene.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

// In the middle of voxels of 10 cm; 20 x 20 of them each.
const Surface ground = {{0, 0, 0.05}, {2, 0, 0}, {0, 2, 0}};
const Surface wall = {{0.05, 0, 0}, {0, 2, 0}, {0, 0, 2}};

/** \brief Rms distance of points that are spread evenly within a noise. */
double
rmsOf (double noise)
{
  return noise / std::sqrt (3.0);
}

/** \brief Ground and wall, whose row of common voxels has a plane's points alone in
 * none of them. */
VoxelScene
groundAndWall ()
{
  return VoxelScene ({{ground}, {wall}}, 1_cm);
}

} // namespace

TEST (Noise, IsTheRmsDistanceToThePlane)
{
  VoxelScene scene ({{ground}}, 1_cm);
  scene.planes.noise.assign (scene.grid().size(), 0.0);
  measureNoise (scene.grid(), 1, scene.planes);
  for (const double noise : scene.planes.noise)
    EXPECT_NEAR (noise, rmsOf (1_cm), 1_mm);
}

TEST (Noise, IsTheInnerOneWhereAPlaneMeetsAnother)
{
  // A voxel of the common row holds points up to 5 cm off the plane it is on.
  VoxelScene scene = groundAndWall();
  measureNoise (scene.grid(), 1, scene.planes);
  for (const double noise : scene.planes.noise)
    EXPECT_NEAR (noise, rmsOf (1_cm), 1_mm);
}

TEST (Noise, IsThatOfTheOwnPlanesVoxelsAlone)
{
  // Two halves of a ground, the plane of the right one 4 cm off its points.
  VoxelScene scene ({{ground}, {{{2, 0, 0.05}, {2, 0, 0}, {0, 2, 0}}}});
  scene.planes.planes[1].offset += 4_cm;
  measureNoise (scene.grid(), 1, scene.planes);
  for (std::size_t i = 0; i < scene.grid().size(); ++i)
    EXPECT_NEAR (scene.planes.noise[i],
                 scene.planes.plane_of_voxel[i] == 0 ? smallestNoise (scene.grid())
                                                     : 4_cm,
                 1e-6);
}

TEST (Noise, IsHandedOnToTheBordersOfAPlane)
{
  // The last quarter of a ground is uneven by 3 cm; it ends at a wall. Next to the wall
  // the noise is that of the quarter, not that of most of the ground.
  VoxelScene scene (
      {{{{0, 0, 0.05}, {3, 0, 0}, {0, 2, 0}}, {{3, 0, 0.08}, {1, 0, 0}, {0, 2, 0}}},
       {{{4.05, 0, 0.1}, {0, 2, 0}, {0, 0, 2}}}});
  measureNoise (scene.grid(), 1, scene.planes);
  for (std::size_t i = 0; i < scene.grid().size(); ++i)
    if (scene.planes.plane_of_voxel[i] == 0 && scene.centroid (i).x() > 3.5) {
      EXPECT_NEAR (scene.planes.noise[i], 3_cm, 1_mm);
    }
}

TEST (Noise, OfAPlaneWithoutInnerVoxelsIsThatOfAllOfThem)
{
  // Two strips of one row each, so that every voxel has one of the other beside it.
  VoxelScene scene ({{{{0, 0, 0.05}, {2, 0, 0}, {0, 0.1, 0}}},
                     {{{0, 0.1, 0.05}, {2, 0, 0}, {0, 0.1, 0}}}},
                    2_cm);
  scene.planes.noise.assign (scene.grid().size(), 0.0);
  measureNoise (scene.grid(), 1, scene.planes);
  for (const double noise : scene.planes.noise)
    EXPECT_NEAR (noise, rmsOf (2_cm), 2_mm);
}

TEST (Noise, OfVoxelsOffPlanesIsLeftAlone)
{
  VoxelScene scene ({{ground}}, 1_cm);
  scene.label (no_plane, [] (const auto& at) { return at.x() < 0.5; });
  scene.planes.noise.assign (scene.grid().size(), 1_m);
  measureNoise (scene.grid(), 1, scene.planes);
  for (std::size_t i = 0; i < scene.grid().size(); ++i)
    EXPECT_EQ (scene.planes.noise[i] == 1_m,
               scene.planes.plane_of_voxel[i] == no_plane);
}

TEST (Noise, IsNotMeasuredMoreFinelyThanAShareOfAVoxel)
{
  VoxelScene scene ({{ground}});
  scene.planes.noise.assign (scene.grid().size(), 0.0);
  measureNoise (scene.grid(), 1, scene.planes);
  EXPECT_EQ (scene.planes.noise,
             std::vector<double> (400, smallestNoise (scene.grid())));
}

TEST (Noise, IsTheSameForAnyNumberOfThreads)
{
  VoxelScene one = groundAndWall(), four = one;
  measureNoise (one.grid(), 1, one.planes);
  measureNoise (four.grid(), 4, four.planes);
  EXPECT_EQ (one.planes.noise, four.planes.noise);
}

TEST (Noise, FloorsFollowTheVoxelSize)
{
  VoxelGrid grid;
  grid.voxel_size = 10_cm;
  EXPECT_DOUBLE_EQ (smallestNoise (grid), 3_mm);
  EXPECT_DOUBLE_EQ (distanceLimit (grid, std::nullopt), 20_cm) << "two voxels";
  EXPECT_DOUBLE_EQ (distanceLimit (grid, 3_cm), 3_cm) << "theta_h";
  EXPECT_DOUBLE_EQ (smallestBand (grid, 1_m), 2_cm);
  EXPECT_DOUBLE_EQ (smallestBand (grid, 1_cm), 1_cm) << "never above theta_h";
}

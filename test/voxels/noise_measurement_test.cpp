// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/bounded_planes.h"

using namespace pcl_ops::internal;

TEST (Noise, IsMeasuredOnThePlanesOwnVoxelsAndIsAtLeastAShareOfTheirSize)
{
  // Two exact surfaces side by side. Plane 1 is moved 4 cm off its points.
  VoxelScene scene ({{ground}, {{{2, 0, 0.05}, {2, 0, 0}, {0, 2, 0}}}});
  scene.planes.planes[1].offset += 4_cm;
  measureNoise (scene.grid(), one_thread, scene.planes);
  EXPECT_NEAR (scene.planes.noise.at (0), 3_mm, 1e-6) << "3 % of a voxel of 10 cm";
  EXPECT_NEAR (scene.planes.noise.at (1), 4_cm, 1e-6);
}

TEST (Noise, IsThatOfMostOfThePlaneAndStaysForAPlaneWithoutVoxels)
{
  // Nine tenths of plane 0 are ground; the rest is a carpet, 3 cm higher. Plane 1 has
  // no voxels.
  VoxelScene scene ({{{{0, 0, 0.05}, {1.8, 0, 0}, {0, 2, 0}},
                      {{1.8, 0, 0.08}, {0.2, 0, 0}, {0, 2, 0}}}},
                    1_cm);
  scene.addPlane ({Eigen::Vector3d::UnitX(), 7.0});
  scene.planes.noise[1] = 1_m;
  measureNoise (scene.grid(), one_thread, scene.planes);
  // The standard deviation of a uniform distribution from -1 cm to 1 cm.
  EXPECT_NEAR (scene.planes.noise[0], 1_cm / std::sqrt (3.0), 1_mm);
  EXPECT_EQ (scene.planes.noise[1], 1_m);
}

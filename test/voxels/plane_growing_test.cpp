// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/plane_growing.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief The surface of the ground that goes on 2 m farther, some way up. */
Surface
higherBy (double height)
{
  return {{2, 0, 0.05 + height}, {2, 0, 0}, {0, 2, 0}};
}

void
grow (VoxelScene& scene, std::optional<double> theta_h = std::nullopt)
{
  growPlanes (scene.grid(), theta_h, 1, scene.planes);
}

} // namespace

TEST (Growing, ReachesTheVoxelsAtTheEdgeOfAPlane)
{
  VoxelScene scene ({{ground}, {wall}}, 5_mm);
  scene.label (no_plane, [] (const auto& at) { return at.x() < 0.4 && at.z() < 0.4; });
  EXPECT_GT (voxelsOn (no_plane, scene.planes), 100u);
  grow (scene);
  // A row of voxels where ground and wall meet belongs to neither alone.
  EXPECT_LE (voxelsOn (no_plane, scene.planes), 21u);
}

TEST (Growing, GoesOnForAsFarAsThereAreVoxels)
{
  // All but the first row, so that each row can be taken after the one before only.
  VoxelScene scene ({{ground}});
  scene.label (no_plane, [] (const auto& at) { return at.x() > 0.1; });
  EXPECT_EQ (voxelsOn (0, scene.planes), 20u);
  grow (scene);
  EXPECT_EQ (voxelsOn (0, scene.planes), 400u);
}

TEST (Growing, GivesAVoxelToTheNearerOfThePlanesNextToIt)
{
  // Next to the step of 1 cm either plane could take it, at 1.67 times the noise.
  for (const double row : {1.9, 2.0}) {
    VoxelScene scene ({{ground}, {higherBy (1_cm)}});
    scene.label (no_plane,
                 [row] (const auto& at) { return at.x() > row && at.x() < row + 0.1; });
    EXPECT_EQ (voxelsOn (no_plane, scene.planes), 20u);
    grow (scene);
    EXPECT_EQ (voxelsOn (0, scene.planes), 400u);
    EXPECT_EQ (voxelsOn (1, scene.planes), 400u);
  }
}

TEST (Growing, TakesVoxelsUpToThreeTimesTheNoiseAndTheThreshold)
{
  // What lies beyond three quarters of the ground is on no plane.
  const struct {
    double height, noise;
    std::optional<double> theta_h;
    std::size_t voxels;
  } rows[] = {{10_cm, 6_mm, {}, 400},
              {1_cm, 3_mm, {}, 400},
              {1_cm, 4_mm, {}, 800},
              {8_mm, 6_mm, 5_mm, 400},
              {8_mm, 6_mm, 1_cm, 800}};
  for (const auto& row : rows) {
    VoxelScene scene ({{ground}, {higherBy (row.height)}});
    scene.label (no_plane, [] (const auto& at) { return at.x() > 1.5; });
    scene.planes.noise[0] = row.noise;
    grow (scene, row.theta_h);
    EXPECT_EQ (voxelsOn (0, scene.planes), row.voxels) << row.height;
    EXPECT_EQ (voxelsOn (no_plane, scene.planes), 800 - row.voxels) << row.height;
  }
}

TEST (Growing, RefitsThePlanes)
{
  VoxelScene scene ({{ground}});
  scene.planes.planes[0].normal = Eigen::Vector3d (0.1, 0, 1).normalized();
  grow (scene);
  EXPECT_TRUE (isNear (scene.planes.planes[0], ground, 1e-6, 1e-6));
}

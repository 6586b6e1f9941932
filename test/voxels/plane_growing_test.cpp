// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/plane_growing.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief A surface as large as the ground, beside it and above it by \p height [m];
 * it begins at x = 2 m. */
Surface
besideGround (double height)
{
  return {{2, 0, 0.05 + height}, {2, 0, 0}, {0, 2, 0}};
}

void
grow (VoxelScene& scene, std::optional<double> distance_threshold = std::nullopt)
{
  growPlanes (scene.grid(), distance_threshold, one_thread, scene.planes);
}

} // namespace

TEST (Growing, ReachesTheVoxelsAtTheEdgeOfAPlane)
{
  VoxelScene scene ({{ground}, {wall}}, 5_mm);
  scene.label (no_plane, [] (const Eigen::Vector3d& centroid) {
    return centroid.x() < 0.4 && centroid.z() < 0.4;
  });
  EXPECT_GT (countVoxelsOn (no_plane, scene.planes), 100u);
  grow (scene);
  // The 20 voxels along the edge, where ground and wall meet, hold points of both.
  EXPECT_LE (countVoxelsOn (no_plane, scene.planes), 20u);
}

TEST (Growing, GoesOnForAsFarAsThereAreVoxels)
{
  // All rows of voxels but the first are on no plane at first. So each row can only be
  // taken after the row before.
  VoxelScene scene ({{ground}});
  scene.label (no_plane,
               [] (const Eigen::Vector3d& centroid) { return centroid.x() > 0.1; });
  EXPECT_EQ (countVoxelsOn (0, scene.planes), 20u);
  grow (scene);
  EXPECT_EQ (countVoxelsOn (0, scene.planes), voxels_of_surface);
}

TEST (Growing, GivesAVoxelToTheNearerOfThePlanesNextToIt)
{
  // A row of voxels on the lower or the upper side of a step of 1 cm is on no plane.
  // Either plane may take it, since 1 cm is 1.67 times their noise.
  for (const double row_begin : {1.9_m, 2.0_m}) {
    VoxelScene scene ({{ground}, {besideGround (1_cm)}});
    scene.label (no_plane, [row_begin] (const Eigen::Vector3d& centroid) {
      return centroid.x() > row_begin && centroid.x() < row_begin + 10_cm;
    });
    EXPECT_EQ (countVoxelsOn (no_plane, scene.planes), 20u);
    grow (scene);
    EXPECT_EQ (countVoxelsOn (0, scene.planes), voxels_of_surface);
    EXPECT_EQ (countVoxelsOn (1, scene.planes), voxels_of_surface);
  }
}

TEST (Growing, TakesVoxelsUpToThreeTimesTheNoiseAndTheThreshold)
{
  // The last quarter of the ground and the surface beside it are on no plane at first.
  // The plane of the ground takes the quarter, and that surface if it is near enough.
  const struct {
    double height; // of the surface beside the ground [m]
    double noise;  // of the ground's plane [m]
    std::optional<double> distance_threshold;
    std::size_t voxels; // of the ground's plane after it grew
  } rows[] = {{10_cm, 6_mm, {}, voxels_of_surface},
              {1_cm, 3_mm, {}, voxels_of_surface},
              {1_cm, 4_mm, {}, 2 * voxels_of_surface},
              {8_mm, 6_mm, 5_mm, voxels_of_surface},
              {8_mm, 6_mm, 1_cm, 2 * voxels_of_surface}};
  for (const auto& row : rows) {
    VoxelScene scene ({{ground}, {besideGround (row.height)}});
    scene.label (no_plane,
                 [] (const Eigen::Vector3d& centroid) { return centroid.x() > 1.5; });
    scene.planes.noise[0] = row.noise;
    grow (scene, row.distance_threshold);
    EXPECT_EQ (countVoxelsOn (0, scene.planes), row.voxels) << row.height;
    EXPECT_EQ (countVoxelsOn (no_plane, scene.planes),
               2 * voxels_of_surface - row.voxels)
        << row.height;
  }
}

TEST (Growing, RefitsThePlanes)
{
  VoxelScene scene ({{ground}});
  scene.planes.planes[0].normal = Eigen::Vector3d (0.1, 0, 1).normalized();
  grow (scene);
  EXPECT_TRUE (isNear (scene.planes.planes[0], ground, 1e-6, 1e-6));
}

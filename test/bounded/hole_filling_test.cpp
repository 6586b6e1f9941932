// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/hole_filling.h"
#include "voxel_scene.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

// In the middle of voxels of 10 cm; 20 x 20 of them.
const Surface ground = {{0, 0, 0.05}, {2, 0, 0}, {0, 2, 0}};

/** \brief Whether a voxel is in a square of so many voxels in the middle. */
template <int voxels>
bool
isInTheMiddle (const Eigen::Vector3d& at)
{
  constexpr double edge = 0.1 * voxels;
  return at.x() > 0.5 && at.x() < 0.5 + edge && at.y() > 0.5 && at.y() < 0.5 + edge;
}

} // namespace

TEST (HoleFilling, FillsAHoleOfAVoxel)
{
  VoxelScene scene ({{ground}});
  scene.label (no_plane, isInTheMiddle<1>);
  ASSERT_EQ (scene.voxelsOn (no_plane), 1u);
  fillHoles (scene.grid(), 1, scene.planes);
  EXPECT_EQ (scene.voxelsOn (no_plane), 0u);
}

TEST (HoleFilling, FillsAHoleOfThreeVoxelsAcrossButNoneMuchWider)
{
  VoxelScene scene ({{ground}});
  scene.label (no_plane, isInTheMiddle<3>);
  ASSERT_EQ (scene.voxelsOn (no_plane), 9u);
  fillHoles (scene.grid(), 1, scene.planes);
  EXPECT_EQ (scene.voxelsOn (no_plane), 0u);
  scene.label (no_plane, isInTheMiddle<8>);
  fillHoles (scene.grid(), 1, scene.planes);
  EXPECT_GE (scene.voxelsOn (no_plane), 4u * 4u) << "two rows from each side at most";
}

TEST (HoleFilling, LeavesPointsThatThePlaneDoesNotExplain)
{
  // A thing of 10 x 10 cm lies on the ground: within a voxel, but 4 cm off the plane.
  VoxelScene scene ({{ground}, {{{0.5, 0.5, 0.09}, {0.1, 0, 0}, {0, 0.1, 0}}}});
  scene.label (no_plane, isInTheMiddle<1>);
  ASSERT_EQ (scene.voxelsOn (no_plane), 1u);
  fillHoles (scene.grid(), 1, scene.planes);
  EXPECT_EQ (scene.voxelsOn (no_plane), 1u);
}

TEST (HoleFilling, AllowsForTheNoiseAround)
{
  VoxelScene scene ({{ground}, {{{0.5, 0.5, 0.09}, {0.1, 0, 0}, {0, 0.1, 0}}}});
  scene.label (no_plane, isInTheMiddle<1>);
  scene.planes.noise.assign (scene.grid().size(), 2_cm);
  fillHoles (scene.grid(), 1, scene.planes);
  EXPECT_EQ (scene.voxelsOn (no_plane), 0u);
}

TEST (HoleFilling, AsksForHalfOfTheNeighbours)
{
  // The left third is on the plane: next to it no voxel has more of it than three.
  VoxelScene scene ({{ground}});
  scene.label (no_plane, [] (const auto& at) { return at.x() > 0.7; });
  const std::size_t before = scene.voxelsOn (no_plane);
  fillHoles (scene.grid(), 1, scene.planes);
  EXPECT_EQ (scene.voxelsOn (no_plane), before);
}

TEST (HoleFilling, TakesTheNoiseOfTheVoxelsAround)
{
  VoxelScene scene ({{ground}});
  scene.label (no_plane, isInTheMiddle<1>);
  for (std::size_t i = 0; i < scene.grid().size(); ++i)
    scene.planes.noise[i] = scene.planes.plane_of_voxel[i] == no_plane ? 1_m : 2_cm;
  fillHoles (scene.grid(), 1, scene.planes);
  for (const double noise : scene.planes.noise)
    EXPECT_NEAR (noise, 2_cm, 1e-9);
}

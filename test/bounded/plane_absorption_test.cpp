// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/plane_absorption.h"
#include "voxel_scene.h"

using namespace pcl_ops::internal;

namespace {

const Surface ground = {{0, 0, 0.05}, {2, 0, 0}, {0, 2, 0}};

/** \brief Adds a copy of the ground's plane that has its voxels up to some way along.
 */
void
splitOff (double width, VoxelScene& scene)
{
  const auto splinter = static_cast<std::int32_t> (scene.planes.size());
  scene.planes.planes.push_back (scene.planes.planes[0]);
  scene.label (splinter, [width] (const auto& at) { return at.x() < width; });
}

} // namespace

TEST (Absorption, GivesASplinterToThePlaneAroundIt)
{
  VoxelScene scene ({{ground}}, 5_mm);
  splitOff (20_cm, scene);
  absorbPlanes (scene.grid(), 1.8, scene.planes);
  EXPECT_EQ (scene.planes.size(), 1u);
  EXPECT_EQ (scene.voxelsOn (0), 400u);
}

TEST (Absorption, GivesASplinterOfASplinterToThePlaneAroundThem)
{
  VoxelScene scene ({{ground}}, 5_mm);
  splitOff (40_cm, scene);
  splitOff (10_cm, scene); // touches the first alone
  absorbPlanes (scene.grid(), 1.8, scene.planes);
  EXPECT_EQ (scene.planes.size(), 1u);
  EXPECT_EQ (scene.voxelsOn (0), 400u);
}

TEST (Absorption, GoesOnWhereAnAbsorbedPlaneWasInBetween)
{
  // Three strips: the first and the last touch when one of them has the middle one.
  VoxelScene scene ({{ground}}, 5_mm);
  splitOff (1.2_m, scene);
  splitOff (80_cm, scene);
  absorbPlanes (scene.grid(), 1.8, scene.planes);
  EXPECT_EQ (scene.planes.size(), 1u);
  EXPECT_EQ (scene.voxelsOn (0), 400u);
}

TEST (Absorption, LeavesAStepOfManyTimesTheNoise)
{
  VoxelScene scene ({{ground}, {{{2, 0, 0.13}, {2, 0, 0}, {0, 2, 0}}}}, 5_mm);
  absorbPlanes (scene.grid(), 1.8, scene.planes);
  EXPECT_EQ (scene.planes.size(), 2u);
}

TEST (Absorption, TakesAStepThatTheNoiseOfTheLargerExplains)
{
  // 3 cm up: five times the smallest noise, once a noise of 3 cm.
  for (const double noise : {6_mm, 3_cm}) {
    VoxelScene scene ({{ground}, {{{2, 0, 0.08}, {1, 0, 0}, {0, 2, 0}}}});
    scene.planes.noise.assign (scene.grid().size(), noise);
    absorbPlanes (scene.grid(), 1.8, scene.planes);
    EXPECT_EQ (scene.planes.size(), noise < 1_cm ? 2u : 1u);
  }
}

TEST (Absorption, LeavesCoplanarPlanesThatDoNotTouch)
{
  VoxelScene scene ({{ground}, {{{3, 0, 0.05}, {1, 0, 0}, {0, 2, 0}}}});
  absorbPlanes (scene.grid(), 1.8, scene.planes);
  EXPECT_EQ (scene.planes.size(), 2u);
}

TEST (Absorption, RefitsThePlaneThatTookAnother)
{
  // Half of the ground at 5 cm, a smaller half at 6 cm: together in between.
  VoxelScene scene ({{ground}, {{{2, 0, 0.06}, {1.9, 0, 0}, {0, 2, 0}}}});
  absorbPlanes (scene.grid(), 1.8, scene.planes);
  ASSERT_EQ (scene.planes.size(), 1u);
  EXPECT_NEAR (std::abs (scene.planes.planes[0].distance ({2, 1, 0.05})), 5_mm, 1_mm);
}

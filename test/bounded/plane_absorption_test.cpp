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
  absorbPlanes (scene.grid(), 2.0, scene.planes);
  EXPECT_EQ (scene.planes.size(), 1u);
  EXPECT_EQ (scene.voxelsOn (0), 400u);
}

TEST (Absorption, GivesASplinterOfASplinterToThePlaneAroundThem)
{
  VoxelScene scene ({{ground}}, 5_mm);
  splitOff (40_cm, scene);
  splitOff (10_cm, scene); // touches the first alone
  absorbPlanes (scene.grid(), 2.0, scene.planes);
  EXPECT_EQ (scene.planes.size(), 1u);
  EXPECT_EQ (scene.voxelsOn (0), 400u);
}

TEST (Absorption, GoesOnWhereAnAbsorbedPlaneWasInBetween)
{
  // Three strips: the first and the last touch when one of them has the middle one.
  VoxelScene scene ({{ground}}, 5_mm);
  splitOff (1.2_m, scene);
  splitOff (80_cm, scene);
  absorbPlanes (scene.grid(), 2.0, scene.planes);
  EXPECT_EQ (scene.planes.size(), 1u);
  EXPECT_EQ (scene.voxelsOn (0), 400u);
}

TEST (Absorption, LeavesAStepOfManyTimesTheNoise)
{
  VoxelScene scene ({{ground}, {{{2, 0, 0.13}, {2, 0, 0}, {0, 2, 0}}}}, 5_mm);
  absorbPlanes (scene.grid(), 2.0, scene.planes);
  EXPECT_EQ (scene.planes.size(), 2u);
}

TEST (Absorption, TakesAStepThatTheNoiseOfBothExplains)
{
  // 3 cm up, with points within 3 mm and within 3 cm of their surface.
  for (const double noise : {3_mm, 3_cm}) {
    VoxelScene scene ({{ground}, {{{2, 0, 0.08}, {1, 0, 0}, {0, 2, 0}}}}, noise);
    absorbPlanes (scene.grid(), 2.0, scene.planes);
    EXPECT_EQ (scene.planes.size(), noise < 1_cm ? 2u : 1u);
  }
}

TEST (Absorption, GoesByTheNoiseOnTheOthersSideOfTheBorder)
{
  // A strip without noise 8 mm above the ground: with a noise of 1 cm there it fits.
  const Surface strip = {{2, 0, 0.058}, {0.1, 0, 0}, {0, 2, 0}};
  for (const double noise : {1_mm, 1_cm}) {
    VoxelScene scene ({{ground}}, 1_cm);
    addGrid (scene.points, strip, 12);
    scene.voxelized = voxelize (scene.points, 10_cm, 1);
    scene.planes.planes.push_back (
        pcl_ops::planeThrough (strip.centre(), strip.normal()));
    scene.planes.plane_of_voxel.assign (scene.grid().size(), 0);
    scene.planes.noise.assign (scene.grid().size(), noise);
    scene.label (1, [] (const auto& at) { return at.x() > 2.0; });
    absorbPlanes (scene.grid(), 2.0, scene.planes);
    EXPECT_EQ (scene.planes.size(), noise < 5_mm ? 2u : 1u);
  }
}

TEST (Absorption, TakesNothingThatTheLargerWouldSufferFrom)
{
  // The smaller could be that noisy, but the points of the larger lie within 3 mm.
  VoxelScene scene ({{ground}, {{{2, 0, 0.08}, {1, 0, 0}, {0, 2, 0}}}}, 3_mm);
  scene.planes.noise.assign (scene.grid().size(), 5_cm);
  absorbPlanes (scene.grid(), 2.0, scene.planes);
  EXPECT_EQ (scene.planes.size(), 2u);
}

TEST (Absorption, WeighsWhatAPlaneHasElsewhere)
{
  // The ground is larger than these voxels show: it gives way less to what it takes.
  VoxelScene scene ({{ground}, {{{2, 0, 0.056}, {1.9, 0, 0}, {0, 2, 0}}}}, 1_cm);
  const VoxelScene elsewhere ({{{{-50, -50, 0.05}, {40, 0, 0}, {0, 100, 0}},
                                {{10, -50, 0.05}, {40, 0, 0}, {0, 100, 0}}}});
  scene.planes.beyond = momentsOfPlanes (elsewhere.grid(), elsewhere.planes);
  absorbPlanes (scene.grid(), 2.0, scene.planes);
  ASSERT_EQ (scene.planes.size(), 1u);
  EXPECT_LT (std::abs (scene.planes.planes[0].distance ({2, 1, 0.05})), 2_mm)
      << "3 mm were there no more than the two";
}

TEST (Absorption, LeavesCoplanarPlanesThatDoNotTouch)
{
  VoxelScene scene ({{ground}, {{{3, 0, 0.05}, {1, 0, 0}, {0, 2, 0}}}});
  absorbPlanes (scene.grid(), 2.0, scene.planes);
  EXPECT_EQ (scene.planes.size(), 2u);
}

TEST (Absorption, RefitsThePlaneThatTookAnother)
{
  // Half of the ground at 5 cm, a smaller half at 6 cm: together in between.
  VoxelScene scene ({{ground}, {{{2, 0, 0.06}, {1.9, 0, 0}, {0, 2, 0}}}}, 1_cm);
  absorbPlanes (scene.grid(), 2.0, scene.planes);
  ASSERT_EQ (scene.planes.size(), 1u);
  EXPECT_NEAR (std::abs (scene.planes.planes[0].distance ({2, 1, 0.05})), 5_mm, 1_mm);
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/plane_absorption.h"

using namespace pcl_ops::internal;

namespace {

/** \brief Adds a copy of plane 0, which takes all voxels with x < \p width [m]. */
void
splitOff (double width, VoxelScene& scene)
{
  const auto splinter = static_cast<std::int32_t> (scene.planes.size());
  scene.addPlane (scene.planes.planes[0]);
  scene.label (splinter, [width] (const auto& at) { return at.x() < width; });
}

/** \brief For each plane the index of the plane that absorbs it. */
pcl_ops::Labels
absorbed (const VoxelScene& scene)
{
  return absorbPlanes (scene.grid(), 2.0, scene.planes);
}

/** \brief Index of the plane that absorbs a strip at a height above a ground [m], when
 * both have this noise [m]. */
std::int32_t
absorberOfStrip (double height, double noise_of_ground, double noise_of_strip)
{
  const Surface strip = {{2, 0, 0.05 + height}, {0.1, 0, 0}, {0, 2, 0}};
  VoxelScene scene ({{ground}});
  addGrid (scene.points, strip, 12);
  scene.voxelize();
  scene.addPlane (pcl_ops::planeThrough (strip.center(), strip.normal()));
  scene.planes.noise = {noise_of_ground, noise_of_strip};
  scene.label (1, [] (const auto& at) { return at.x() > 2.0; });
  return absorbed (scene)[1];
}

} // namespace

TEST (Absorption, GivesSplintersToThePlaneAroundThem)
{
  // One splinter; one of a splinter, which it touches alone; and three strips, of which
  // the first and the last touch when one of them has the middle one.
  for (const std::vector<double>& widths :
       {std::vector<double>{20_cm}, {40_cm, 10_cm}, {1.2_m, 80_cm}}) {
    VoxelScene scene ({{ground}}, 5_mm);
    for (const double width : widths)
      splitOff (width, scene);
    const pcl_ops::Labels into = absorbed (scene);
    EXPECT_EQ (std::count (into.begin(), into.end(), into[0]), into.size());
  }
}

TEST (Absorption, TakesAPlaneThatTouchesOneAndIsNoHigherThanTheNoiseOfBothExplains)
{
  const struct {
    const char* other;
    double x, height, noise;
    std::int32_t into;
  } rows[] = {{"a step of many times the noise", 2_m, 8_cm, 5_mm, 1},
              {"one of seven times the noise", 2_m, 2_cm, 3_mm, 1},
              {"not as high as the noise", 2_m, 2_cm, 3_cm, 0},
              {"coplanar, but apart", 3_m, 0_m, 0_m, 1}};
  for (const auto& row : rows) {
    const Surface other = {{row.x, 0, 0.05 + row.height}, {1, 0, 0}, {0, 2, 0}};
    EXPECT_EQ (absorbed (VoxelScene ({{ground}, {other}}, row.noise)),
               (pcl_ops::Labels{0, row.into}))
        << row.other;
  }
}

TEST (Absorption, TakesABumpThatTheNoiseOfBothExplainsButNoRoughPatchOfACleanPlane)
{
  EXPECT_EQ (absorberOfStrip (15_mm, 9_mm, 9_mm), 0);
  EXPECT_EQ (absorberOfStrip (15_mm, 9_mm, 1_mm), 1) << "of its own noise it is sure";
  EXPECT_EQ (absorberOfStrip (8_cm, 5_cm, 5_cm), 0);
  EXPECT_EQ (absorberOfStrip (8_cm, 5_mm, 5_cm), 1);
}

TEST (Absorption, WeighsWhatAPlaneHasElsewhere)
{
  // A strip 6 mm above the ground is larger than the ground here, but not in all.
  for (const bool has_more : {false, true}) {
    VoxelScene scene ({{{{0, 0, 0.05}, {1.5, 0, 0}, {0, 2, 0}}},
                       {{{1.5, 0, 0.056}, {2, 0, 0}, {0, 2, 0}}}},
                      1_cm);
    const VoxelScene elsewhere ({{{{-50, -50, 0.05}, {40, 0, 0}, {0, 100, 0}}}});
    if (has_more)
      scene.planes.moments_elsewhere =
          momentsOfPlanes (elsewhere.grid(), elsewhere.planes);
    scene.label (1, [] (const auto& at) { return at.x() > 1.4; });
    EXPECT_EQ (absorbed (scene)[0], has_more ? 0 : 1);
  }
}

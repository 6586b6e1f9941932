// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/plane_absorption.h"

using namespace pcl_ops::internal;

namespace {

/** \brief Adds a copy of plane 0, and puts all voxels with x < \p width [m] on it. */
void
splitOff (double width, VoxelScene& scene)
{
  const auto splinter = static_cast<std::int32_t> (scene.planes.size());
  scene.addPlane (scene.planes.planes[0]);
  scene.label (splinter, [width] (const Eigen::Vector3d& centroid) {
    return centroid.x() < width;
  });
}

/** \brief For each plane the index of the plane that absorbs it; its own if none does.
 */
pcl_ops::Labels
absorbersIn (const VoxelScene& scene)
{
  constexpr double noise_factor = 2.0;
  return absorbPlanes (scene.grid(), noise_factor, scene.planes);
}

// Plane 1 beside the ground, which is plane 0: who absorbs it.
constexpr std::int32_t by_ground = 0;
constexpr std::int32_t by_none = 1; // it keeps its own index

/** \brief Index of the plane that absorbs a strip 10 cm wide beside the ground.
 * \param[in] height of the strip above the ground [m]
 * \param[in] noise_of_ground,noise_of_strip noise of the planes [m] */
std::int32_t
absorberOfStrip (double height, double noise_of_ground, double noise_of_strip)
{
  const Surface strip = {{2, 0, 0.05 + height}, {0.1, 0, 0}, {0, 2, 0}};
  constexpr int strip_steps = 12;
  VoxelScene scene ({{ground}});
  addGrid (scene.points, strip, strip_steps);
  scene.voxelize();
  scene.addPlane (pcl_ops::planeThrough (strip.center(), strip.normal()));
  scene.planes.noise = {noise_of_ground, noise_of_strip};
  scene.label (1, [] (const Eigen::Vector3d& centroid) { return centroid.x() > 2.0; });
  return absorbersIn (scene)[1];
}

} // namespace

TEST (Absorption, GivesSplintersToThePlaneAroundThem)
{
  // Each width splits off the part of the ground with smaller x. The rows are: one
  // splinter; a second splinter, which touches only the first; and three strips, of
  // which the outer two are adjacent only after one of them has absorbed the middle
  // one.
  for (const std::vector<double>& widths :
       {std::vector<double>{20_cm}, {40_cm, 10_cm}, {1.2_m, 80_cm}}) {
    VoxelScene scene ({{ground}}, 5_mm);
    for (const double width : widths)
      splitOff (width, scene);
    const pcl_ops::Labels absorbers = absorbersIn (scene);
    EXPECT_EQ (std::count (absorbers.begin(), absorbers.end(), absorbers[0]),
               absorbers.size());
  }
}

TEST (Absorption, GoesOnToTheNeighborsOfAPlaneThatItTook)
{
  // Three strips of the ground: plane 1, plane 0 and plane 2, which are 70 cm, 20 cm
  // and 1.1 m wide. Plane 0 fits plane 1 better, which has more noise. Only after plane
  // 1 has absorbed it, planes 1 and 2 touch.
  VoxelScene scene ({{ground}}, 5_mm);
  for (int added = 0; added < 2; ++added)
    scene.addPlane (scene.planes.planes[0]);
  scene.label (1, [] (const Eigen::Vector3d& centroid) { return centroid.x() < 0.7; });
  scene.label (2, [] (const Eigen::Vector3d& centroid) { return centroid.x() > 0.9; });
  scene.planes.noise[1] = 9_mm;
  EXPECT_EQ (absorbersIn (scene), (pcl_ops::Labels{2, 2, 2}));
}

TEST (Absorption, JoinsPlanesThatTouchIfTheirStepIsWithinTheirNoise)
{
  const struct {
    const char* other;
    double x;          // where the other plane begins; the ground ends at 2 m
    double height;     // of the other plane above the ground [m]
    double max_offset; // of the points of both planes from their plane [m]
    std::int32_t absorber;
  } rows[] = {{"a step of 16 times the offsets", 2_m, 8_cm, 5_mm, by_none},
              {"a step of 7 times the offsets", 2_m, 2_cm, 3_mm, by_none},
              {"a step smaller than the offsets", 2_m, 2_cm, 3_cm, by_ground},
              {"coplanar, 1 m from the ground", 3_m, 0_m, 0_m, by_none}};
  for (const auto& row : rows) {
    const Surface other = {{row.x, 0, 0.05 + row.height}, {1, 0, 0}, {0, 2, 0}};
    EXPECT_EQ (absorbersIn (VoxelScene ({{ground}, {other}}, row.max_offset)),
               (pcl_ops::Labels{0, row.absorber}))
        << row.other;
  }
}

TEST (Absorption, NeedsTheNoiseOfBothPlanesToExplainTheStep)
{
  EXPECT_EQ (absorberOfStrip (15_mm, 9_mm, 9_mm), by_ground);
  EXPECT_EQ (absorberOfStrip (15_mm, 9_mm, 1_mm), by_none) << "a clean strip";
  EXPECT_EQ (absorberOfStrip (8_cm, 5_cm, 5_cm), by_ground);
  EXPECT_EQ (absorberOfStrip (8_cm, 5_mm, 5_cm), by_none) << "a rough strip";
}

TEST (Absorption, CountsPointsOutsideTheseVoxels)
{
  // The smaller plane is absorbed by the larger one. In these voxels plane 1, which is
  // 6 mm above plane 0, has more points: it also gets the last row of voxels of plane
  // 0. But plane 0 may have more points elsewhere.
  for (const bool has_points_elsewhere : {false, true}) {
    VoxelScene scene ({{{{0, 0, 0.05}, {1.5, 0, 0}, {0, 2, 0}}},
                       {{{1.5, 0, 0.056}, {2, 0, 0}, {0, 2, 0}}}},
                      1_cm);
    const VoxelScene elsewhere ({{{{-50, -50, 0.05}, {40, 0, 0}, {0, 100, 0}}}});
    if (has_points_elsewhere)
      scene.planes.moments_elsewhere =
          momentsOfPlanes (elsewhere.grid(), elsewhere.planes);
    scene.label (1,
                 [] (const Eigen::Vector3d& centroid) { return centroid.x() > 1.4; });
    EXPECT_EQ (absorbersIn (scene)[0], has_points_elsewhere ? 0 : 1);
  }
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/bounded_assignment.h"

using pcl_ops::Labels;
using pcl_ops::no_plane;
using pcl_ops::Plane;
using namespace pcl_ops::internal;

namespace {

/** \brief Assigns each point to a plane at most four times the plane's noise away. */
AssignedPoints
assign (const VoxelScene& scene)
{
  constexpr std::nullopt_t no_threshold = std::nullopt;
  constexpr double noise_factor = 4.0;
  const std::vector<char> no_voxel_left_out;
  AssignedPoints assigned{Labels (scene.points.size(), no_plane), {}};
  assignToBoundedPlanes (scene.points,
                         scene.grid(),
                         scene.planes,
                         no_threshold,
                         noise_factor,
                         one_thread,
                         no_voxel_left_out,
                         assigned);
  return assigned;
}

} // namespace

TEST (BoundedAssignment, GivesTheMomentsOfThePointsItLabels)
{
  const VoxelScene scene ({{ground}, {wall}}, 5_mm);
  const AssignedPoints assigned = assign (scene);
  const std::vector<pcl_ops::Moments> expected =
      momentsOfLabels (scene.points, assigned.labels, 2, one_thread);
  ASSERT_EQ (assigned.moments.size(), 2u);
  for (const std::size_t plane : {0, 1}) {
    // Of the 14,400 points of a surface, those near the other surface may go to it.
    EXPECT_GT (assigned.moments[plane].count, 14000.0);
    EXPECT_EQ (assigned.moments[plane].count, expected[plane].count);
    EXPECT_LT ((assigned.moments[plane].sum - expected[plane].sum).norm(), 1e-6);
  }
}

TEST (BoundedAssignment, GivesAPointBetweenPlanesToTheNoisierAndOneOnBothToTheCleaner)
{
  // The points lie at z = 5 cm. Voxels with x < 1 m are on plane 0, which lies below
  // the points; the other voxels are on plane 1, as far above the points. 3 cm are 0.75
  // times the noise of the noisier plane and 3 times that of the cleaner one.
  VoxelScene scene ({{ground}});
  scene.label (1, [] (const Eigen::Vector3d& centroid) { return centroid.x() > 1.0; });
  for (const double distance : {3_cm, 1_mm})
    for (const std::int32_t noisier : {0, 1}) {
      scene.planes.planes = {Plane{Eigen::Vector3d::UnitZ(), distance - 5_cm},
                             Plane{Eigen::Vector3d::UnitZ(), -distance - 5_cm}};
      scene.planes.noise = {noisier == 0 ? 4_cm : 1_cm, noisier == 1 ? 4_cm : 1_cm};
      const std::int32_t cleaner = 1 - noisier;
      const std::int32_t expected = distance > 1_cm ? noisier : cleaner;
      const Labels labels = assign (scene).labels;
      for (std::size_t i = 0; i < labels.size(); ++i) {
        constexpr float voxel_size = 0.1f; // [m]
        const bool has_both_planes_around =
            std::abs (scene.points.x[i] - 1.0f) <= voxel_size;
        if (has_both_planes_around) {
          EXPECT_EQ (labels[i], expected);
        }
      }
    }
}

TEST (BoundedAssignment, TakesPointsUpToAMultipleOfTheNoise)
{
  // The noise of the plane is 6 mm: it takes points up to 24 mm away. Two points lie
  // above it, each in a voxel of its own, which is on no plane.
  VoxelScene scene ({{{{0, 0, 0.09}, {2, 0, 0}, {0, 2, 0}}}});
  const std::size_t first_above = scene.points.size();
  scene.points.add (0.55f, 0.55f, 0.105f);
  scene.points.add (1.55f, 0.55f, 0.120f);
  scene.voxelize();
  scene.label (no_plane,
               [] (const Eigen::Vector3d& centroid) { return centroid.z() > 0.1; });
  const Labels labels = assign (scene).labels;
  EXPECT_EQ (labels[first_above], 0) << "15 mm above the plane";
  EXPECT_EQ (labels[first_above + 1], no_plane) << "30 mm above the plane";
}

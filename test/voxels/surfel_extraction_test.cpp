// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/surfel_extraction.h"

#include <set>

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

using Surfels = std::vector<std::optional<Surfel>>;

/** \brief A square in 25 voxels, in the plane of the ground but a meter beyond its end.
 */
const Surface tile = {{3, 0, 0.05}, {0.5, 0, 0}, {0, 0.5, 0}};

using Parameters = pcl_ops::OrientedPointSamplingParameters;

/** \brief Of surfels that may be on a plane: their noise over their spread. */
constexpr double max_thickness = 0.25;

/** \brief The surfels of a grid at three resolutions, each of 30 points or more. */
Surfels
usualSurfels (const VoxelGrid& grid)
{
  constexpr int resolutions = 3;
  constexpr double min_points = 30.0;
  return findSurfels (grid, resolutions, min_points, one_thread);
}

/** \brief The planes that given surfels of a grid are on. */
BoundedPlanes
planesAmong (const VoxelGrid& grid,
             const Surfels& surfels,
             const Parameters& parameters = {})
{
  BoundedPlanes planes;
  extractSurfelPlanes (grid, surfels, parameters, max_thickness, planes);
  return planes;
}

/** \brief The planes that the usual surfels of a grid are on. */
BoundedPlanes
planesOf (const VoxelGrid& grid, const Parameters& parameters = {})
{
  return planesAmong (grid, usualSurfels (grid), parameters);
}

/** \brief Voxels of 10 cm of surfaces.
 * \param[in] max_offset of points along the normal, as in \ref addGrid [m] */
VoxelGrid
gridOf (const std::vector<Surface>& surfaces, double max_offset = 0.0)
{
  return VoxelScene ({surfaces}, max_offset).grid();
}

/** \brief Voxels of 10 cm of half a barrel, 2 m long, along z.
 * \param[in] radius [m] */
VoxelGrid
barrel (double radius)
{
  Coordinates points;
  constexpr int steps_of_half_turn = 400, steps_of_length = 200;
  for (int i = 0; i < steps_of_half_turn; ++i)
    for (int j = 0; j < steps_of_length; ++j)
      points.add (static_cast<float> (radius * std::cos (pi * i / steps_of_half_turn)),
                  static_cast<float> (radius * std::sin (pi * i / steps_of_half_turn)),
                  static_cast<float> (0.01 * j));
  return connectedGrid (points, 10_cm);
}

/** \brief A surfel through the centroid of each voxel, of thickness 0 and noise 0
 * unless \p change sets other values.
 * \param[in] change called with (surfel, centroid) for each; may set the normal, the
 * thickness and the noise of the surfel */
template <typename Change>
Surfels
surfelsWith (const VoxelGrid& grid, Change&& change)
{
  Surfels surfels;
  for (const pcl_ops::Moments& voxel : grid.moments) {
    Surfel surfel;
    surfel.thickness = 0.0;
    change (surfel, voxel.centroid());
    surfel.plane = pcl_ops::planeThrough (voxel.centroid(), surfel.plane.normal);
    surfels.push_back (surfel);
  }
  return surfels;
}

/** \brief A normal that leans from z towards x by an angle [rad]. */
Eigen::Vector3d
leaning (double angle)
{
  return {std::sin (angle), 0, std::cos (angle)};
}

} // namespace

TEST (VoxelExtraction, DoesNotGoRoundACorner)
{
  const VoxelGrid grid = gridOf ({ground, wall}, 5_mm);
  const BoundedPlanes planes = planesOf (grid);
  ASSERT_EQ (planes.size(), 2u);
  for (const std::int32_t plane : {0, 1})
    EXPECT_GT (countVoxelsOn (plane, planes), voxels_of_surface / 2);
  const bool is_ground_first = std::abs (planes.planes[0].normal.z()) > 0.5;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Eigen::Vector3d centroid = grid.moments[i].centroid();
    const bool is_on_ground = planes.plane_of_voxel[i] == (is_ground_first ? 0 : 1);
    const bool is_on_wall = planes.plane_of_voxel[i] != no_plane && !is_on_ground;
    EXPECT_FALSE (is_on_ground && centroid.z() > 0.1);
    EXPECT_FALSE (is_on_wall && centroid.x() > 0.1);
  }
}

TEST (VoxelExtraction, TellsFloorAndCeilingApart)
{
  const Surface ceiling = {{0, 0, 2.55}, {2, 0, 0}, {0, 2, 0}};
  const BoundedPlanes planes = planesOf (gridOf ({ground, ceiling}, 5_mm));
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_EQ (countVoxelsOn (0, planes), voxels_of_surface);
  EXPECT_EQ (countVoxelsOn (1, planes), voxels_of_surface);
}

TEST (VoxelExtraction, StopsAtAStepOfManyTimesTheNoise)
{
  const Surface step = {{2, 0, 0.09}, {2, 0, 0}, {0, 2, 0}};
  const VoxelGrid grid = gridOf ({ground, step}, 3_mm);
  const BoundedPlanes planes = planesOf (grid);
  ASSERT_EQ (planes.size(), 2u);
  std::set<std::int32_t> planes_before_step, planes_behind_step;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes.plane_of_voxel[i] != no_plane) {
      const bool is_before = grid.moments[i].centroid().x() < 2.0;
      (is_before ? planes_before_step : planes_behind_step)
          .insert (planes.plane_of_voxel[i]);
    }
  EXPECT_EQ (planes_before_step.size() + planes_behind_step.size(), 2u)
      << "a plane is on both sides";
}

TEST (VoxelExtraction, AsksForThetaNConnectedVoxels)
{
  const VoxelGrid grid = gridOf ({tile});
  Parameters parameters; // min_samples is theta_N
  parameters.min_samples = grid.size();
  EXPECT_EQ (planesOf (grid, parameters).size(), 1u);
  parameters.min_samples = grid.size() + 1;
  EXPECT_EQ (planesOf (grid, parameters).size(), 0u);
}

TEST (VoxelExtraction, LeavesAnIslandOfFewerThanThetaNVoxels)
{
  // The tile has 25 voxels.
  const VoxelGrid grid = gridOf ({ground, tile});
  Parameters parameters;
  parameters.min_samples = 25;
  EXPECT_EQ (planesOf (grid, parameters).size(), 2u) << "a plane of its own";
  parameters.min_samples = 26;
  EXPECT_EQ (countVoxelsOn (no_plane, planesOf (grid, parameters)), 25u);
}

TEST (VoxelExtraction, LeavesMostOfABarrelAlone)
{
  // Only a few narrow strips are flat enough for a plane.
  const VoxelGrid slender = barrel (40_cm), wide = barrel (1_m);
  EXPECT_GT (countVoxelsOn (no_plane, planesOf (slender)), 70_percent * slender.size());
  EXPECT_GT (countVoxelsOn (no_plane, planesOf (wide)), 90_percent * wide.size());
}

TEST (VoxelExtraction, BeginsWithTheFlattestSurfels)
{
  // The surfels of a second surface, which begins at x = 5 m, have a thickness of 0.05.
  // Those of the ground, which is larger and has the first voxel, are flatter or
  // thicker.
  for (const double ground_thickness : {0.0, 0.1}) {
    const VoxelGrid grid = gridOf ({ground, {{5, 0, 1}, {1, 0, 0}, {0, 1, 0}}});
    const auto surfels = surfelsWith (
        grid, [ground_thickness] (Surfel& surfel, const Eigen::Vector3d& centroid) {
          surfel.thickness = centroid.x() < 3.0 ? ground_thickness : 0.05;
        });
    const BoundedPlanes planes = planesAmong (grid, surfels);
    ASSERT_EQ (planes.size(), 2u);
    // The ground has an offset of 0.05 m, the other surface one of 1 m.
    EXPECT_NEAR (
        std::abs (planes.planes[0].offset), ground_thickness < 0.05 ? 0.05 : 1.0, 1e-3);
  }
}

TEST (VoxelExtraction, AddsToPlanesFoundBefore)
{
  // The half of the ground with x < 1 m is on a plane already; the other is found now.
  const VoxelGrid grid = gridOf ({ground});
  BoundedPlanes planes;
  planes.planes.push_back ({Eigen::Vector3d::UnitX(), 7.0});
  for (const pcl_ops::Moments& voxel : grid.moments)
    planes.plane_of_voxel.push_back (voxel.centroid().x() < 1.0 ? 0 : no_plane);
  extractSurfelPlanes (grid, usualSurfels (grid), Parameters(), max_thickness, planes);
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_EQ (planes.planes[0].offset, 7.0);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const bool was_found_before = grid.moments[i].centroid().x() < 1.0;
    EXPECT_EQ (planes.plane_of_voxel[i], was_found_before ? 0 : 1);
  }
}

TEST (VoxelExtraction, LeavesOutSurfelsThatLean)
{
  // The normals of the half of the ground with x > 1 m lean by 40 degrees, which is
  // more than the default limit of 30. Its surfels are thicker, so that planes begin at
  // the other half.
  const VoxelGrid grid = gridOf ({ground});
  const auto surfels =
      surfelsWith (grid, [] (Surfel& surfel, const Eigen::Vector3d& centroid) {
        surfel.plane.normal = leaning (centroid.x() < 1.0 ? 0.0 : 40_deg);
        surfel.thickness = centroid.x() < 1.0 ? 0.0 : 0.1;
      });
  Parameters parameters;
  EXPECT_EQ (countVoxelsOn (0, planesAmong (grid, surfels, parameters)),
             voxels_of_surface / 2);
  parameters.surfels.angle_threshold = 50_deg;
  EXPECT_EQ (countVoxelsOn (0, planesAmong (grid, surfels, parameters)),
             voxels_of_surface);
}

TEST (VoxelExtraction, LeavesOutThickSurfelsAndVoxelsWithoutOne)
{
  const VoxelGrid grid = gridOf ({ground});
  Surfels surfels =
      surfelsWith (grid, [] (Surfel& surfel, const Eigen::Vector3d& centroid) {
        surfel.thickness = max_thickness + (centroid.x() < 0.5 ? 0.01 : -0.01);
      });
  const BoundedPlanes planes = planesAmong (grid, surfels);
  EXPECT_EQ (countVoxelsOn (0, planes), 300u);
  EXPECT_EQ (countVoxelsOn (no_plane, planes), 100u);
  for (std::optional<Surfel>& surfel : surfels)
    if (surfel->thickness > max_thickness)
      surfel.reset();
  EXPECT_EQ (countVoxelsOn (no_plane, planesAmong (grid, surfels)), 100u);
}

TEST (VoxelExtraction, RefitsAPlaneOnItsWay)
{
  // Every surfel leans by 3 degrees: the plane of the first surfel alone is farther
  // from the ground than the noise allows from 20 cm on.
  const VoxelGrid grid = gridOf ({ground});
  const auto surfels = surfelsWith (grid, [] (Surfel& surfel, const auto&) {
    surfel.plane.normal = leaning (3_deg);
  });
  Parameters parameters;
  parameters.min_samples = voxels_of_surface;
  const BoundedPlanes planes = planesAmong (grid, surfels, parameters);
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_EQ (countVoxelsOn (0, planes), voxels_of_surface);
  constexpr double max_angle = 1e-3; // [rad]
  EXPECT_TRUE (isNear (planes.planes[0], ground, max_angle, 1_mm));
}

TEST (VoxelExtraction, TakesNoMoreThanHalfAgainTheNoiseOfTheVoxelBefore)
{
  // The surfels of 79 rows of voxels have a noise of 1 cm. Those of the last row have a
  // noise of 10 cm, as next to another surface, which counts as 1.5 cm. A voxel may be
  // twice its noise off the plane (noise_factor): 3 cm.
  for (const double distance : {2_cm, 4_cm}) {
    const VoxelGrid grid =
        gridOf ({{{0, 0, 0.05}, {7.9, 0, 0}, {0, 2, 0}},
                 {{7.9, 0, 0.05 + distance}, {0.1, 0, 0}, {0, 2, 0}}},
                5_mm);
    const auto surfels =
        surfelsWith (grid, [] (Surfel& surfel, const Eigen::Vector3d& centroid) {
          surfel.noise = centroid.x() > 7.9 ? 10_cm : 1_cm;
          surfel.thickness = centroid.x() > 7.9 ? 0.1 : 0.0;
        });
    EXPECT_EQ (countVoxelsOn (0, planesAmong (grid, surfels)),
               distance < 3_cm ? 80 * 20u : 79 * 20u);
  }
}

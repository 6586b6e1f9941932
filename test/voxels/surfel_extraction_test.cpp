// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/surfel_extraction.h"

#include <set>

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

using Surfels = std::vector<std::optional<Surfel>>;

const Surface tile = {{3, 0, 0.05}, {0.5, 0, 0}, {0, 0.5, 0}};

using Parameters = pcl_ops::OrientedPointSamplingParameters;

constexpr double max_thickness = 0.25;

BoundedPlanes
planesAmong (const VoxelGrid& grid,
             const Surfels& surfels,
             const Parameters& parameters = {})
{
  BoundedPlanes planes;
  extractSurfelPlanes (grid, surfels, parameters, max_thickness, planes);
  return planes;
}

BoundedPlanes
planesOf (const VoxelGrid& grid, const Parameters& parameters = {})
{
  return planesAmong (grid, findSurfels (grid, 3, 30.0, 1), parameters);
}

VoxelGrid
gridOf (const std::vector<Surface>& surfaces, double noise = 0.0)
{
  return VoxelScene ({surfaces}, noise).grid();
}

/** \brief Half a barrel of a radius, 2 m long. */
VoxelGrid
barrel (double radius)
{
  Coordinates points;
  for (int i = 0; i < 400; ++i)
    for (int j = 0; j < 200; ++j)
      points.add (static_cast<float> (radius * std::cos (pi * i / 400)),
                  static_cast<float> (radius * std::sin (pi * i / 400)),
                  static_cast<float> (0.01 * j));
  return connectedGrid (points, 0.1);
}

/** \brief Every voxel with a surfel through its centroid that a test may change.
 * \param[in] change (surfel, centroid) */
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

/** \brief A normal that leans towards x. */
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
  const bool is_ground_first = std::abs (planes.planes[0].normal.z()) > 0.5;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Eigen::Vector3d at = grid.moments[i].centroid();
    const bool is_on_ground = planes.plane_of_voxel[i] == (is_ground_first ? 0 : 1);
    EXPECT_FALSE (is_on_ground && at.z() > 0.1);
    EXPECT_FALSE (planes.plane_of_voxel[i] != no_plane && !is_on_ground &&
                  at.x() > 0.1);
  }
}

TEST (VoxelExtraction, TellsFloorAndCeilingApart)
{
  const Surface ceiling = {{0, 0, 2.55}, {2, 0, 0}, {0, 2, 0}};
  const BoundedPlanes planes = planesOf (gridOf ({ground, ceiling}, 5_mm));
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_EQ (voxelsOn (0, planes), 400u);
  EXPECT_EQ (voxelsOn (1, planes), 400u);
}

TEST (VoxelExtraction, StopsAtAStepOfManyTimesTheNoise)
{
  const Surface step = {{2, 0, 0.09}, {2, 0, 0}, {0, 2, 0}};
  const VoxelGrid grid = gridOf ({ground, step}, 3_mm);
  const BoundedPlanes planes = planesOf (grid);
  ASSERT_EQ (planes.size(), 2u);
  std::set<std::pair<std::int32_t, bool>> sides;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes.plane_of_voxel[i] != no_plane)
      sides.emplace (planes.plane_of_voxel[i], grid.moments[i].centroid().x() < 2.0);
  EXPECT_EQ (sides.size(), 2u) << "each plane is on one side alone";
}

TEST (VoxelExtraction, AsksForThetaNConnectedVoxels)
{
  const VoxelGrid grid = gridOf ({tile});
  Parameters parameters;
  parameters.min_samples = grid.size();
  EXPECT_EQ (planesOf (grid, parameters).size(), 1u);
  parameters.min_samples = grid.size() + 1;
  EXPECT_EQ (planesOf (grid, parameters).size(), 0u);
}

TEST (VoxelExtraction, LeavesAnIslandOfFewerThanThetaNVoxels)
{
  // 25 voxels a meter beyond the end of the ground, in its plane.
  const VoxelGrid grid = gridOf ({ground, tile});
  Parameters parameters;
  parameters.min_samples = 25;
  EXPECT_EQ (planesOf (grid, parameters).size(), 2u) << "not connected";
  parameters.min_samples = 26;
  EXPECT_EQ (voxelsOn (no_plane, planesOf (grid, parameters)), 25u);
}

TEST (VoxelExtraction, LeavesMostOfABarrelAlone)
{
  const VoxelGrid slender = barrel (40_cm), wide = barrel (1_m);
  EXPECT_GT (voxelsOn (no_plane, planesOf (slender)), 70_percent * slender.size());
  EXPECT_GT (voxelsOn (no_plane, planesOf (wide)), 90_percent * wide.size());
}

TEST (VoxelExtraction, BeginsWithTheFlattestSurfels)
{
  // The wall comes first whichever is larger, and whichever has the first voxel.
  for (const double flat : {0.0, 0.1}) {
    const VoxelGrid grid = gridOf ({ground, {{5, 0, 1}, {1, 0, 0}, {0, 1, 0}}});
    const auto surfels = surfelsWith (grid, [flat] (Surfel& surfel, const auto& at) {
      surfel.thickness = at.x() < 3.0 ? flat : 0.05;
    });
    const BoundedPlanes planes = planesAmong (grid, surfels);
    ASSERT_EQ (planes.size(), 2u);
    EXPECT_NEAR (std::abs (planes.planes[0].offset), flat < 0.05 ? 0.05 : 1.0, 1e-3);
  }
}

TEST (VoxelExtraction, AddsToPlanesFoundBefore)
{
  // The left half of the ground is on a plane already; the right one is found now.
  const VoxelGrid grid = gridOf ({ground});
  BoundedPlanes planes;
  planes.planes.push_back ({Eigen::Vector3d::UnitX(), 7.0});
  for (const pcl_ops::Moments& voxel : grid.moments)
    planes.plane_of_voxel.push_back (voxel.centroid().x() < 1.0 ? 0 : no_plane);
  extractSurfelPlanes (
      grid, findSurfels (grid, 3, 30.0, 1), Parameters(), max_thickness, planes);
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_EQ (planes.planes[0].offset, 7.0);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const bool was_found_before = grid.moments[i].centroid().x() < 1.0;
    EXPECT_EQ (planes.plane_of_voxel[i], was_found_before ? 0 : 1);
  }
}

TEST (VoxelExtraction, LeavesOutSurfelsThatLean)
{
  // The right half of the ground with normals of 40 degrees, and later in turn.
  const VoxelGrid grid = gridOf ({ground});
  const auto surfels = surfelsWith (grid, [] (Surfel& surfel, const auto& at) {
    surfel.plane.normal = leaning (at.x() < 1.0 ? 0.0 : 40_deg);
    surfel.thickness = at.x() < 1.0 ? 0.0 : 0.1;
  });
  Parameters parameters;
  EXPECT_EQ (voxelsOn (0, planesAmong (grid, surfels, parameters)), 200u);
  parameters.surfels.angle_threshold = 50_deg;
  EXPECT_EQ (voxelsOn (0, planesAmong (grid, surfels, parameters)), 400u);
}

TEST (VoxelExtraction, LeavesOutThickSurfelsAndVoxelsWithoutOne)
{
  const VoxelGrid grid = gridOf ({ground});
  Surfels surfels = surfelsWith (grid, [] (Surfel& surfel, const auto& at) {
    surfel.thickness = at.x() < 0.5 ? 0.26 : 0.24;
  });
  const BoundedPlanes planes = planesAmong (grid, surfels);
  EXPECT_EQ (voxelsOn (0, planes), 300u);
  EXPECT_EQ (voxelsOn (no_plane, planes), 100u);
  for (std::optional<Surfel>& surfel : surfels)
    if (surfel->thickness > max_thickness)
      surfel.reset();
  EXPECT_EQ (voxelsOn (no_plane, planesAmong (grid, surfels)), 100u);
}

TEST (VoxelExtraction, RefitsAPlaneOnItsWay)
{
  // Every surfel leans by 3 degrees: the plane of any leaves the ground after 20 cm.
  const VoxelGrid grid = gridOf ({ground});
  const auto surfels = surfelsWith (grid, [] (Surfel& surfel, const auto&) {
    surfel.plane.normal = leaning (3_deg);
  });
  Parameters parameters;
  parameters.min_samples = 400;
  const BoundedPlanes planes = planesAmong (grid, surfels, parameters);
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_EQ (voxelsOn (0, planes), 400u);
  EXPECT_TRUE (isNear (planes.planes[0], ground, 1e-3, 1e-3));
}

TEST (VoxelExtraction, TakesNoMoreThanHalfAgainTheNoiseOfTheVoxelBefore)
{
  // The last of 80 rows has surfels of 10 cm of noise, as next to another surface, and
  // lies off the plane by less or more than twice 1.5 times the noise of 1 cm before
  // it.
  for (const double off : {2_cm, 4_cm}) {
    const VoxelGrid grid = gridOf ({{{0, 0, 0.05}, {7.9, 0, 0}, {0, 2, 0}},
                                    {{7.9, 0, 0.05 + off}, {0.1, 0, 0}, {0, 2, 0}}},
                                   5_mm);
    const auto surfels = surfelsWith (grid, [] (Surfel& surfel, const auto& at) {
      surfel.noise = at.x() > 7.9 ? 10_cm : 1_cm;
      surfel.thickness = at.x() > 7.9 ? 0.1 : 0.0;
    });
    EXPECT_EQ (voxelsOn (0, planesAmong (grid, surfels)), off < 3_cm ? 1600u : 1580u);
  }
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/surfel_extraction.h"
#include "voxel_scene.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

const Surface ground = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
const Surface wall = {{0, 0, 0}, {0, 2, 0}, {0, 0, 2}};
const Surface tile = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}};

/** \brief Thresholds for voxels of 10 cm. */
SurfelRansacParameters
usual ()
{
  SurfelRansacParameters parameters;
  parameters.distance_limit = 20_cm;
  parameters.angle_threshold = 30_deg;
  parameters.largest_normal_spread = 0.13;
  parameters.largest_thickness = 0.3;
  return parameters;
}

BoundedPlanes
planesAmong (const VoxelGrid& grid,
             const std::vector<std::optional<Surfel>>& surfels,
             const SurfelRansacParameters& parameters = usual())
{
  RandomGenerator generator (seedOfTest());
  BoundedPlanes planes;
  extractSurfelPlanes (grid, surfels, parameters, generator, planes);
  return planes;
}

BoundedPlanes
planesOf (const VoxelGrid& grid, const SurfelRansacParameters& parameters = usual())
{
  return planesAmong (grid, findSurfels (grid, 3, 30.0, 1), parameters);
}

VoxelGrid
gridOf (const std::vector<Surface>& surfaces, double noise = 0.0)
{
  return VoxelScene ({surfaces}, noise).grid();
}

/** \brief Two surfels a row apart for each pair of voxels: what they are literally. */
Surfel
surfelAt (const Eigen::Vector3d& centroid, const Eigen::Vector3d& normal)
{
  Surfel surfel;
  surfel.plane = pcl_ops::planeThrough (centroid, normal);
  surfel.thickness = 0.0;
  return surfel;
}

/** \brief Every voxel with a normal of its own. */
template <typename NormalOf>
std::vector<std::optional<Surfel>>
surfelsWith (const VoxelGrid& grid, NormalOf&& normalOf)
{
  std::vector<std::optional<Surfel>> surfels;
  for (const pcl_ops::Moments& voxel : grid.moments)
    surfels.push_back (surfelAt (voxel.centroid(), normalOf (voxel.centroid())));
  return surfels;
}

std::size_t
voxelsOn (std::int32_t plane, const BoundedPlanes& planes)
{
  return static_cast<std::size_t> (
      std::count (planes.plane_of_voxel.begin(), planes.plane_of_voxel.end(), plane));
}

} // namespace

TEST (VoxelExtraction, FindsGroundAndWall)
{
  const BoundedPlanes planes = planesOf (gridOf ({ground, wall}, 5_mm));
  ASSERT_EQ (planes.planes.size(), 2u);
  EXPECT_LT (std::abs (planes.planes[0].normal.dot (planes.planes[1].normal)), 0.02);
}

TEST (VoxelExtraction, AsksForThetaNConnectedVoxels)
{
  const VoxelGrid grid = gridOf ({tile});
  SurfelRansacParameters parameters = usual();
  parameters.min_inliers = grid.size();
  EXPECT_EQ (planesOf (grid, parameters).planes.size(), 1u);
  parameters.min_inliers = grid.size() + 1;
  EXPECT_TRUE (planesOf (grid, parameters).planes.empty());
}

TEST (VoxelExtraction, LeavesMostOfACylinderAlone)
{
  Coordinates points;
  for (int i = 0; i < 400; ++i)
    for (int j = 0; j < 200; ++j) {
      const double angle = 2.0 * pi * i / 400;
      points.add (static_cast<float> (0.4 * std::cos (angle)),
                  static_cast<float> (0.4 * std::sin (angle)),
                  static_cast<float> (0.01 * j));
    }
  const VoxelGrid grid = voxelize (points, 0.1, 1).grid;
  EXPECT_GT (voxelsOn (no_plane, planesOf (grid)), grid.size() / 2);
}

TEST (VoxelExtraction, LeavesAnIslandOfFewerThanThetaNVoxels)
{
  // 25 voxels a metre beyond the end of the ground, in its plane.
  const Surface island = {{3, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}};
  const VoxelGrid grid = gridOf ({ground, island});
  SurfelRansacParameters parameters = usual();
  parameters.min_inliers = 25;
  EXPECT_EQ (voxelsOn (no_plane, planesOf (grid, parameters)), 0u);
  parameters.min_inliers = 26;
  EXPECT_EQ (voxelsOn (no_plane, planesOf (grid, parameters)), 25u);
}

TEST (VoxelExtraction, FindsTheLargestPlaneFirst)
{
  const Surface upper = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  const BoundedPlanes planes = planesOf (gridOf ({upper, ground}));
  ASSERT_EQ (planes.planes.size(), 2u);
  expectPlaneNear (planes.planes[0], ground, 1e-3, 1e-3);
  expectPlaneNear (planes.planes[1], upper, 1e-3, 1e-3);
}

TEST (VoxelExtraction, AddsToPlanesFoundBefore)
{
  const VoxelGrid grid = gridOf ({ground});
  const auto surfels = findSurfels (grid, 3, 30.0, 1);
  BoundedPlanes planes = planesAmong (grid, surfels);
  ASSERT_EQ (planes.size(), 1u);
  RandomGenerator generator (seedOfTest());
  extractSurfelPlanes (grid, surfels, usual(), generator, planes);
  EXPECT_EQ (planes.size(), 1u) << "nothing is left to find";
  EXPECT_EQ (voxelsOn (0, planes), 400u);
}

TEST (VoxelExtraction, LeavesOutSurfelsThatLean)
{
  // The right half of the ground with normals of 40 degrees.
  const VoxelGrid grid = gridOf ({ground});
  const auto surfels = surfelsWith (grid, [] (const auto& at) {
    return Eigen::Vector3d (at.x() < 1.0 ? 0.0 : std::sin (40_deg),
                            0,
                            at.x() < 1.0 ? 1.0 : std::cos (40_deg));
  });
  SurfelRansacParameters parameters = usual();
  EXPECT_EQ (voxelsOn (0, planesAmong (grid, surfels, parameters)), 200u);
  parameters.angle_threshold = 50_deg;
  parameters.largest_normal_spread = 1.0;
  EXPECT_EQ (voxelsOn (0, planesAmong (grid, surfels, parameters)), 400u);
}

TEST (VoxelExtraction, TakesASupportOfSpreadNormalsForNoPlane)
{
  // Normals of plus and minus 15 degrees, as on a ridged roof.
  const VoxelGrid grid = gridOf ({ground});
  const auto surfels = surfelsWith (grid, [] (const auto& at) {
    const double side = at.x() < 1.0 ? 1.0 : -1.0;
    return Eigen::Vector3d (side * std::sin (15_deg), 0, std::cos (15_deg));
  });
  SurfelRansacParameters parameters = usual();
  parameters.distance_limit = 1_m;
  parameters.noise_factor = 1e3;
  EXPECT_TRUE (planesAmong (grid, surfels, parameters).planes.empty());
  parameters.largest_normal_spread = 16_deg;
  EXPECT_EQ (planesAmong (grid, surfels, parameters).planes.size(), 1u);
}

TEST (VoxelExtraction, LeavesOutThickSurfels)
{
  const VoxelGrid grid = gridOf ({ground});
  auto surfels =
      surfelsWith (grid, [] (const auto&) { return Eigen::Vector3d::UnitZ().eval(); });
  for (std::size_t i = 0; i < 100; ++i)
    surfels[i]->thickness = 0.5;
  EXPECT_EQ (voxelsOn (no_plane, planesAmong (grid, surfels)), 100u);
}

TEST (VoxelExtraction, NotesTheNoiseOfSurfels)
{
  const VoxelGrid grid = gridOf ({ground});
  auto surfels =
      surfelsWith (grid, [] (const auto&) { return Eigen::Vector3d::UnitZ().eval(); });
  for (auto& surfel : surfels)
    surfel->noise = 3_cm;
  EXPECT_EQ (planesAmong (grid, surfels).noise, std::vector<double> (400, 3_cm));
}

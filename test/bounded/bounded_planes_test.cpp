// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/bounded_planes.h"
#include "grid_scene.h"

using pcl_ops::BoundedPlanes;
using pcl_ops::Coordinates;
using pcl_ops::SurfelRansacParameters;
using pcl_ops::VoxelGrid;
using pcl_ops::VoxelizedPoints;

namespace {

const Surface ground = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
const Surface wall = {{0, 0, 0}, {0, 2, 0}, {0, 0, 2}};

BoundedPlanes
planesOf (const VoxelGrid& grid,
          const SurfelRansacParameters& parameters = SurfelRansacParameters())
{
  const auto normals =
      pcl_ops::findSurfels (grid, pcl_ops::SurfelNormalParameters(), 1);
  pcl_ops::RandomGenerator generator (seedOfTest());
  BoundedPlanes planes;
  pcl_ops::extractBoundedPlanes (grid, normals, parameters, generator, planes);
  return planes;
}

VoxelizedPoints
gridOf (const std::vector<Surface>& surfaces, double noise = 0.0)
{
  Coordinates points;
  for (const Surface& surface : surfaces)
    addGrid (points, surface, 120, noise);
  return pcl_ops::voxelize (points, 0.1, 1);
}

// Voxels on no plane.
std::size_t
voxelsLeft (const BoundedPlanes& planes)
{
  return static_cast<std::size_t> (std::count (
      planes.plane_of_voxel.begin(), planes.plane_of_voxel.end(), pcl_ops::no_plane));
}

} // namespace

TEST (VoxelExtraction, FindsGroundAndWall)
{
  const BoundedPlanes planes = planesOf (gridOf ({ground, wall}, 5_mm).grid);
  ASSERT_EQ (planes.planes.size(), 2u);
  EXPECT_LT (std::abs (planes.planes[0].normal.dot (planes.planes[1].normal)), 0.02);
}

TEST (VoxelExtraction, AsksForThetaNConnectedVoxels)
{
  const Surface tile = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}};
  const VoxelGrid grid = gridOf ({tile}).grid;
  SurfelRansacParameters parameters;
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
  const VoxelGrid grid = pcl_ops::voxelize (points, 0.1, 1).grid;
  EXPECT_GT (voxelsLeft (planesOf (grid)), grid.size() / 2);
}

TEST (Growing, ReachesTheVoxelsAtTheEdgeOfAPlane)
{
  const VoxelGrid grid = gridOf ({ground, wall}, 5_mm).grid;
  BoundedPlanes planes = planesOf (grid);
  const std::size_t before = voxelsLeft (planes);
  pcl_ops::growPlanes (grid, pcl_ops::GrowingParameters(), 1, planes);
  EXPECT_LE (voxelsLeft (planes), before);
  // A row of voxels where ground and wall meet belongs to neither alone.
  EXPECT_LE (voxelsLeft (planes), 21u);
}

TEST (Absorption, GivesASplinterToThePlaneAroundIt)
{
  const VoxelGrid grid = gridOf ({ground}, 5_mm).grid;
  BoundedPlanes planes = planesOf (grid);
  planes.planes.push_back (planes.planes[0]);
  for (std::size_t voxel = 0; voxel < grid.size() / 10; ++voxel)
    planes.plane_of_voxel[voxel] = 1;
  pcl_ops::absorbPlanes (grid, 1.8, planes);
  EXPECT_EQ (planes.planes.size(), 1u);
}

TEST (Absorption, LeavesAStepOfManyTimesTheNoise)
{
  const Surface step = {{2, 0, 0.08}, {2, 0, 0}, {0, 2, 0}};
  const VoxelGrid grid = gridOf ({ground, step}, 5_mm).grid;
  BoundedPlanes planes = planesOf (grid);
  const std::size_t before = planes.planes.size();
  pcl_ops::absorbPlanes (grid, 1.8, planes);
  EXPECT_EQ (before, 2u);
  EXPECT_EQ (planes.planes.size(), before);
}

TEST (Noise, IsTheRmsDistanceToThePlane)
{
  const VoxelGrid grid = gridOf ({ground}, 1_cm).grid;
  BoundedPlanes planes = planesOf (grid);
  pcl_ops::measureNoise (grid, 1, planes);
  for (std::size_t voxel = 0; voxel < grid.size(); ++voxel)
    EXPECT_TRUE (planes.plane_of_voxel[voxel] == pcl_ops::no_plane ||
                 std::abs (planes.noise[voxel] - 1_cm / std::sqrt (3.0)) < 1_mm);
}

TEST (BoundedAssignment, LabelsNoPointBeyondTheEndOfItsPlane)
{
  Coordinates points;
  addGrid (points, ground, 120);
  const std::size_t on_the_ground = points.size();
  // A chair leg's worth of points at the height of the ground, a metre beyond its end.
  addGrid (points, {{3, 0, 0}, {0.05, 0, 0}, {0, 0.05, 0}}, 10);
  const VoxelizedPoints voxelized = pcl_ops::voxelize (points, 0.1, 1);
  const auto assigned = pcl_ops::assignToBoundedPlanes (
      points, voxelized, planesOf (voxelized.grid), {}, 1);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ (assigned.labels[i], i < on_the_ground ? 0 : pcl_ops::no_plane);
}

TEST (BoundedAssignment, GivesTheMomentsOfThePointsItLabels)
{
  Coordinates points;
  addGrid (points, ground, 120, 5_mm);
  addGrid (points, wall, 120, 5_mm);
  const VoxelizedPoints voxelized = pcl_ops::voxelize (points, 0.1, 1);
  const BoundedPlanes planes = planesOf (voxelized.grid);
  const auto assigned =
      pcl_ops::assignToBoundedPlanes (points, voxelized, planes, {}, 1);
  const auto expected =
      pcl_ops::momentsOfLabels (points, assigned.labels, planes.planes.size(), 1);
  for (std::size_t p = 0; p < expected.size(); ++p) {
    EXPECT_EQ (assigned.moments[p].count, expected[p].count);
    EXPECT_LT ((assigned.moments[p].sum - expected[p].sum).norm(), 1e-6);
  }
}

TEST (BoundedAssignment, IsTheSameForAnyNumberOfThreads)
{
  Coordinates points;
  addGrid (points, ground, 300, 5_mm);
  addGrid (points, wall, 300, 5_mm);
  const VoxelizedPoints voxelized = pcl_ops::voxelize (points, 0.1, 1);
  const BoundedPlanes planes = planesOf (voxelized.grid);
  const auto one = pcl_ops::assignToBoundedPlanes (points, voxelized, planes, {}, 1);
  const auto four = pcl_ops::assignToBoundedPlanes (points, voxelized, planes, {}, 4);
  EXPECT_EQ (one.labels, four.labels);
}

namespace {

// Two table tops of one height with the floor below, seen from above.
const Surface left_top = {{-1.2, -0.4, 1}, {0.9, 0, 0}, {0, 0.9, 0}};
const Surface right_top = {{0.3, -0.4, 1}, {0.9, 0, 0}, {0, 0.9, 0}};
const Surface wide_floor = {{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
const Surface lamp = {{-0.4, -0.5, 2}, {0.8, 0, 0}, {0, 1, 0}};
const Eigen::Vector3d above (0, 0, 3);

std::size_t
planesAtHeight (double height, const BoundedPlanes& planes)
{
  return static_cast<std::size_t> (
      std::count_if (planes.planes.begin(),
                     planes.planes.end(),
                     [height] (const pcl_ops::Plane& plane) {
                       return std::abs (std::abs (plane.offset) - height) < 0.05;
                     }));
}

std::size_t
tableTopsFoundAmong (const std::vector<Surface>& surfaces)
{
  const VoxelGrid grid = gridOf (surfaces).grid;
  BoundedPlanes planes = planesOf (grid);
  EXPECT_EQ (planesAtHeight (1.0, planes), 1u) << "one plane before";
  pcl_ops::separateSurfaces (grid, above, 20, planes);
  return planesAtHeight (1.0, planes);
}

} // namespace

TEST (SeparateSurfaces, KeepsTableTopsApartWhereTheFloorIsSeenBetween)
{
  EXPECT_EQ (tableTopsFoundAmong ({left_top, right_top, wide_floor}), 2u);
}

TEST (SeparateSurfaces, TakesATableTopForOneWhereALampHidesItsMiddle)
{
  EXPECT_EQ (tableTopsFoundAmong ({left_top, right_top, wide_floor, lamp}), 1u);
}

TEST (SeparateSurfaces, TakesATableTopForOneWhereNothingIsSeenBetween)
{
  EXPECT_EQ (tableTopsFoundAmong ({left_top, right_top}), 1u);
}

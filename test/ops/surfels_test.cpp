// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "ops/surfels.h"

using pcl_ops::Coordinates;
using pcl_ops::SurfelNormalParameters;
using pcl_ops::VoxelGrid;

namespace {

const Surface floor_of_the_scene = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
const Surface wall_of_the_scene = {{0, 0, 0}, {0, 2, 0}, {0, 0, 2}};

double
angleOf (const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::acos (std::min (1.0, std::abs (a.dot (b))));
}

// The least angle of a voxel's normal to one of the directions.
double
angleToNearest (const pcl_ops::Surfel& normal,
                const std::vector<Eigen::Vector3d>& directions)
{
  double least = pi;
  for (const Eigen::Vector3d& direction : directions)
    least = std::min (least, angleOf (normal.plane.normal, direction));
  return least;
}

} // namespace

TEST (OrientedVoxels, HaveTheNormalOfAnExactPlane)
{
  Coordinates points;
  const Surface board = {{0, 0, 1}, {2, 0, 0.4}, {0, 2, 0.8}};
  addGrid (points, board, 100);
  const VoxelGrid grid = pcl_ops::voxelize (points, 0.1, 1).grid;
  for (const auto& normal : pcl_ops::findSurfels (grid, SurfelNormalParameters(), 1)) {
    ASSERT_TRUE (normal.has_value());
    EXPECT_LT (angleOf (normal->plane.normal, board.normal()), 1e-3);
    EXPECT_LT (normal->noise, 1e-5);
  }
}

TEST (OrientedVoxels, MeasureTheNoiseAroundThem)
{
  Coordinates points;
  // Evenly spread within +-2 cm: a standard deviation of 2 cm / sqrt (3).
  addGrid (points, floor_of_the_scene, 200, 2_cm);
  const VoxelGrid grid = pcl_ops::voxelize (points, 0.1, 1).grid;
  for (const auto& normal : pcl_ops::findSurfels (grid, SurfelNormalParameters(), 1)) {
    ASSERT_TRUE (normal.has_value());
    EXPECT_NEAR (normal->noise, 2_cm / std::sqrt (3.0), 2_mm);
  }
}

TEST (OrientedVoxels, KeepTheirOwnSurfacesNormalNextToAnEdge)
{
  Coordinates points;
  addGrid (points, floor_of_the_scene, 120);
  addGrid (points, wall_of_the_scene, 120);
  const VoxelGrid grid = pcl_ops::voxelize (points, 0.1, 1).grid;
  const auto normals = pcl_ops::findSurfels (grid, SurfelNormalParameters(), 1);
  std::size_t bent = 0;
  for (const auto& normal : normals)
    bent += !normal ||
            angleToNearest (
                *normal, {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()}) > 5_deg;
  // Only the voxels that hold points of both surfaces, one row of twenty, may bend.
  EXPECT_LE (bent, 20u);
}

TEST (OrientedVoxels, OfAnEdgeBendWithoutTheirNeighboursHelp)
{
  Coordinates points;
  addGrid (points, floor_of_the_scene, 120);
  addGrid (points, wall_of_the_scene, 120);
  const VoxelGrid grid = pcl_ops::voxelize (points, 0.1, 1).grid;
  SurfelNormalParameters alone;
  alone.noise_factor = 1e6;
  alone.flat_enough = 1.0;
  std::size_t bent = 0;
  for (const auto& normal : pcl_ops::findSurfels (grid, alone, 1))
    bent += !normal ||
            angleToNearest (
                *normal, {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()}) > 5_deg;
  EXPECT_GT (bent, 20u);
}

TEST (OrientedVoxels, OfABallAreThick)
{
  pcl_ops::RandomGenerator generator (seedOfTest());
  Coordinates points;
  for (int i = 0; i < 2000; ++i) {
    const auto draw = [&] { return static_cast<float> (drawNormal (generator)); };
    const float x = draw(), y = draw(), z = draw();
    points.add (x, y, z);
  }
  const VoxelGrid grid = pcl_ops::voxelize (points, 20.0, 1).grid;
  for (const auto& normal : pcl_ops::findSurfels (grid, SurfelNormalParameters(), 1))
    EXPECT_TRUE (!normal || normal->thickness > 0.8);
}

TEST (OrientedVoxels, AreTheSameForAnyNumberOfThreads)
{
  Coordinates points;
  addGrid (points, floor_of_the_scene, 200, 1_cm);
  const VoxelGrid grid = pcl_ops::voxelize (points, 0.05, 1).grid;
  const auto one = pcl_ops::findSurfels (grid, SurfelNormalParameters(), 1);
  const auto four = pcl_ops::findSurfels (grid, SurfelNormalParameters(), 4);
  for (std::size_t c = 0; c < grid.size(); ++c) {
    ASSERT_EQ (one[c].has_value(), four[c].has_value());
    EXPECT_TRUE (!one[c] || one[c]->plane.normal == four[c]->plane.normal);
  }
}

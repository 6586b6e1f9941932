// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/refinement.h"

using pcl_ops::Moments;
using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

bool
isRight (const Eigen::Vector3d& centroid)
{
  return centroid.x() > 1.0;
}

/** \brief The ground; only its left half is on its plane. */
VoxelScene
halfExplained ()
{
  VoxelScene scene ({{ground}});
  scene.label (no_plane, isRight);
  return scene;
}

Refinement
refined (const VoxelScene& scene)
{
  return refine (scene.voxelized, scene.planes, one_thread);
}

} // namespace

TEST (Refinement, IsOfVoxelsWithoutAPlaneAndTheirNeighbors)
{
  const VoxelScene scene = halfExplained();
  const Refinement refinement = refined (scene);
  ASSERT_EQ (refinement.is_refined.size(), voxels_of_surface);
  for (std::size_t i = 0; i < scene.grid().size(); ++i)
    EXPECT_EQ (refinement.is_refined[i] != 0, scene.centroid (i).x() > 0.9);
}

TEST (Refinement, HasThePointsOfItsVoxels)
{
  const VoxelScene scene = halfExplained();
  const VoxelGrid finer = refined (scene).grid;
  std::vector<char> is_refined (scene.points.size(), 0);
  for (std::size_t voxel = 0; voxel < finer.size(); ++voxel)
    for (const std::uint32_t point : finer.pointsOf (voxel))
      is_refined[point] = 1;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    EXPECT_EQ (is_refined[i] != 0, scene.points.x[i] > 0.9f);
}

TEST (Refinement, OfAllVoxelsHasAllPoints)
{
  VoxelScene scene ({{ground}});
  scene.label (no_plane, [] (const Eigen::Vector3d&) { return true; });
  const VoxelGrid finer = refined (scene).grid;
  std::size_t points = 0;
  double points_of_moments = 0.0;
  for (std::size_t voxel = 0; voxel < finer.size(); ++voxel) {
    const IndexRange of_voxel = finer.pointsOf (voxel);
    points += static_cast<std::size_t> (of_voxel.end() - of_voxel.begin());
    points_of_moments += finer.moments[voxel].count;
  }
  EXPECT_EQ (points, scene.points.size());
  EXPECT_EQ (points_of_moments, static_cast<double> (points));
}

TEST (Refinement, HalvesTheVoxels)
{
  const Refinement refinement = refined (halfExplained());
  const VoxelGrid& grid = refinement.grid;
  EXPECT_DOUBLE_EQ (grid.voxel_size, 5_cm);
  EXPECT_EQ (grid.size(), 11u * 20u * 4u) << "eleven rows of twenty, each in four";
  EXPECT_EQ (grid.neighbors.occupied.size(), grid.size());
}

TEST (Refinement, LeavesVoxelsOfTooFewPointsForAPlane)
{
  // Seven points a meter above the ground, and then an eighth.
  for (const int number : {7, 8}) {
    VoxelScene scene ({{ground}});
    for (int i = 0; i < number; ++i)
      scene.points.add (0.55f, 0.55f, 1.01f + 0.01f * static_cast<float> (i));
    scene.voxelize();
    scene.label (no_plane,
                 [] (const Eigen::Vector3d& centroid) { return centroid.z() > 0.5; });
    EXPECT_EQ (refined (scene).grid.size() > 0, number == 8);
  }
}

TEST (Refinement, LosesNoPointOfAPlane)
{
  // What stays in coarse voxels and what goes to finer ones adds up to the whole.
  VoxelScene scene ({{ground}}, 1_cm);
  scene.label (no_plane, isRight);
  Refinement refinement = refined (scene);
  refinement.planes.plane_of_voxel.assign (refinement.grid.size(), 0);
  const Moments all = momentsOfPlanes (refinement.grid, refinement.planes).at (0);
  EXPECT_LT (refinement.planes.moments_elsewhere.at (0).count, 0.5 * all.count);
  EXPECT_EQ (all.count, points_of_surface);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    sum += scene.points[i];
  EXPECT_LT ((all.sum - sum).norm(), 1e-3);
}

TEST (Refinement, IsEmptyWhereAllVoxelsAreOnPlanes)
{
  const Refinement refinement = refined (VoxelScene ({{ground}}));
  EXPECT_EQ (refinement.grid.size(), 0u);
  EXPECT_EQ (refinement.is_refined, std::vector<char> (voxels_of_surface, 0));
  EXPECT_EQ (refinement.planes.moments_elsewhere.at (0).count, points_of_surface);
}

TEST (Refinement, GivesFinerVoxelsThePlaneOfTheirCoarseVoxel)
{
  const VoxelScene scene = halfExplained();
  const Refinement refinement = refined (scene);
  const VoxelGrid& grid = refinement.grid;
  ASSERT_EQ (refinement.planes.size(), 1u);
  EXPECT_EQ (refinement.planes.planes[0].offset, scene.planes.planes[0].offset);
  for (std::size_t i = 0; i < grid.size(); ++i)
    EXPECT_EQ (refinement.planes.plane_of_voxel[i],
               isRight (grid.moments[i].centroid()) ? no_plane : 0);
}

TEST (Refinement, GivesFinerVoxelsNoPlaneThatTheirPointsAreNotOn)
{
  // An object of 5 x 5 cm lies 4 cm above the ground, within a voxel of the tenth row.
  // That row is the last one on the plane. It is refined as the neighbor of the voxels
  // without a plane.
  constexpr double limit = 8_cm; // z of centroids: 9 cm at the object, 5 cm elsewhere
  VoxelScene scene ({{ground}});
  addGrid (scene.points, {{0.95, 0.5, 0.09}, {0.05, 0, 0}, {0, 0.05, 0}}, 12);
  scene.voxelize();
  scene.label (no_plane, isRight);
  const Refinement refinement = refined (scene);
  const VoxelGrid& grid = refinement.grid;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Eigen::Vector3d centroid = grid.moments[i].centroid();
    EXPECT_EQ (refinement.planes.plane_of_voxel[i],
               isRight (centroid) || centroid.z() > limit ? no_plane : 0);
  }
}

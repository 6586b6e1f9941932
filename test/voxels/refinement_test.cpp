// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/refinement.h"

using pcl_ops::Moments;
using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief Whether a voxel is in the half of the ground that has no plane. */
bool
isUnexplained (const Eigen::Vector3d& centroid)
{
  return centroid.x() > 1.0;
}

/** \brief The ground; only its half with x < 1 m is on its plane. */
VoxelScene
halfExplained ()
{
  VoxelScene scene ({{ground}});
  scene.label (no_plane, isUnexplained);
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
  // The neighbors are the row from x = 0.9 m to 1 m.
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
  EXPECT_EQ (grid.size(), 11u * 20u * 4u) << "11 rows of 20 voxels, each in 4";
  EXPECT_EQ (grid.neighbors.occupied.size(), grid.size());
}

TEST (Refinement, LeavesOutVoxelsOfTooFewPointsForAPlane)
{
  // A voxel a meter above the ground with fewer points than the eight that are enough,
  // or as many.
  for (const int point_count : {7, 8}) {
    VoxelScene scene ({{ground}});
    for (int i = 0; i < point_count; ++i)
      scene.points.add (0.55f, 0.55f, 1.01f + 0.01f * static_cast<float> (i));
    scene.voxelize();
    scene.label (no_plane,
                 [] (const Eigen::Vector3d& centroid) { return centroid.z() > 0.5; });
    EXPECT_EQ (refined (scene).grid.size() > 0, point_count == 8);
  }
}

TEST (Refinement, LosesNoPointOfAPlane)
{
  // The points that stay in coarse voxels and those in finer voxels are all points.
  VoxelScene scene ({{ground}}, 1_cm);
  scene.label (no_plane, isUnexplained);
  Refinement refinement = refined (scene);
  refinement.planes.plane_of_voxel.assign (refinement.grid.size(), 0);
  const Moments all = momentsOfPlanes (refinement.grid, refinement.planes).at (0);
  EXPECT_LT (refinement.planes.moments_elsewhere.at (0).count, 0.5 * all.count);
  EXPECT_EQ (all.count, points_of_surface);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    sum += scene.points[i];
  EXPECT_LT ((all.sum - sum).norm(), 1_mm);
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
  ASSERT_GT (grid.size(), 0u);
  for (std::size_t i = 0; i < grid.size(); ++i)
    EXPECT_EQ (refinement.planes.plane_of_voxel[i],
               isUnexplained (grid.moments[i].centroid()) ? no_plane : 0);
}

TEST (Refinement, GivesFinerVoxelsNoPlaneThatTheirPointsAreNotOn)
{
  // An object of 5 x 5 cm is 4 cm above the ground, in a voxel of the row from x = 0.9
  // m to 1 m. That row is on the plane, and is refined as the neighbor of voxels
  // without a plane.
  constexpr double min_z_of_object = 8_cm; // centroids: 9 cm there, 5 cm on the ground
  VoxelScene scene ({{ground}});
  addGrid (scene.points, {{0.95, 0.5, 0.09}, {0.05, 0, 0}, {0, 0.05, 0}}, 12);
  scene.voxelize();
  scene.label (no_plane, isUnexplained);
  const Refinement refinement = refined (scene);
  const VoxelGrid& grid = refinement.grid;
  std::size_t voxels_of_object = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Eigen::Vector3d centroid = grid.moments[i].centroid();
    voxels_of_object += !isUnexplained (centroid) && centroid.z() > min_z_of_object;
    EXPECT_EQ (refinement.planes.plane_of_voxel[i],
               isUnexplained (centroid) || centroid.z() > min_z_of_object ? no_plane
                                                                          : 0);
  }
  EXPECT_GT (voxels_of_object, 0u);
}

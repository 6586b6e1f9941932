// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "voxels/bounded_planes.h"
#include "voxels/surfels.h"
#include "voxels/voxel_choice.h"

using namespace pcl_ops::internal;

namespace {

const Surface floor_of_the_scene = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
const Surface wall_of_the_scene = {{0, 0, 0}, {0, 2, 0}, {0, 0, 2}};

constexpr int three_resolutions = 3;

/** \brief Surfels at three resolutions. As in the engine on voxels, a neighborhood has
 * 30 points or more, and as many as eight voxels hold on average or more. */
std::vector<std::optional<Surfel>>
surfelsOf (const VoxelGrid& grid)
{
  const double min_points = std::max (30.0, 8.0 * meanPointsPerVoxel (grid));
  return findSurfels (grid, three_resolutions, min_points, one_thread);
}

/** \brief Voxels of 10 cm of the floor, with steps x steps points.
 * \param[in] max_offset of points along the normal, as in \ref addGrid [m] */
VoxelGrid
floorOf (int steps, double max_offset = 0.0)
{
  return connectedGrid (gridsOf ({floor_of_the_scene}, steps, max_offset), 10_cm);
}

/** \brief Voxels of 10 cm of the floor and the wall, which meet at an edge. */
VoxelGrid
floorAndWall ()
{
  return connectedGrid (gridsOf ({floor_of_the_scene, wall_of_the_scene}, 120), 10_cm);
}

/** \brief Whether a normal at the edge is neither the floor's nor the wall's. */
bool
isBent (const Eigen::Vector3d& normal)
{
  return angleBetween (normal, floor_of_the_scene.normal()) > 5_deg &&
         angleBetween (normal, wall_of_the_scene.normal()) > 5_deg;
}

} // namespace

TEST (OrientedVoxels, HaveTheNormalOfAnExactPlane)
{
  const Surface board = {{0, 0, 1}, {2, 0, 0.4}, {0, 2, 0.8}};
  for (const std::optional<Surfel>& surfel :
       surfelsOf (connectedGrid (gridsOf ({board}, 100), 10_cm))) {
    ASSERT_TRUE (surfel.has_value());
    EXPECT_LT (angleBetween (surfel->plane.normal, board.normal()), 1e-3);
    EXPECT_LT (surfel->noise, 1e-5);
  }
}

TEST (OrientedVoxels, MeasureTheNoiseAroundThem)
{
  // Evenly spread within +-2 cm: a standard deviation of 2 cm / sqrt (3).
  const VoxelGrid grid = floorOf (200, 2_cm);
  for (const std::optional<Surfel>& surfel : surfelsOf (grid)) {
    ASSERT_TRUE (surfel.has_value());
    EXPECT_NEAR (surfel->noise, 2_cm / std::sqrt (3.0), 2_mm);
  }
}

TEST (OrientedVoxels, KeepTheirOwnSurfacesNormalNextToAnEdge)
{
  std::size_t bent = 0;
  for (const std::optional<Surfel>& surfel : surfelsOf (floorAndWall()))
    bent += !surfel || isBent (surfel->plane.normal);
  // Only the voxels that hold points of both surfaces, one row of twenty, may bend.
  EXPECT_LE (bent, 20u);
}

TEST (OrientedVoxels, OfAnEdgeBendWithoutTheirNeighborsHelp)
{
  const VoxelGrid grid = floorAndWall();
  std::size_t bent = 0;
  for (std::size_t voxel = 0; voxel < grid.size(); ++voxel) {
    const auto fit = fitPlane (momentsOf (grid.moments, grid.neighbors[voxel]));
    bent += !fit || isBent (fit->plane.normal);
  }
  EXPECT_GT (bent, 20u);
}

TEST (OrientedVoxels, OfAVolumeAreThick)
{
  constexpr double edge_of_cube = 4_m;
  // The eight voxels that meet in the middle of the cube are neighbors: each has all
  // points around it.
  constexpr double edge_of_voxel = 20_m;
  for (const std::optional<Surfel>& surfel :
       surfelsOf (connectedGrid (pointsInACube (2000, edge_of_cube), edge_of_voxel)))
    EXPECT_TRUE (!surfel || surfel->thickness > 0.8);
}

TEST (OrientedVoxels, TakeACoarserNeighborhoodWhereNoiseHidesTheFinest)
{
  // Offsets up to 5 cm, an rms of 3 cm, in voxels of 5 cm: thick at one resolution,
  // flat at three.
  const VoxelGrid grid =
      connectedGrid (gridsOf ({floor_of_the_scene}, 200, 5_cm), 0.05);
  const auto meanThickness = [&grid] (int resolutions) {
    double sum = 0.0;
    for (const std::optional<Surfel>& surfel :
         findSurfels (grid, resolutions, 30.0, one_thread))
      sum += surfel ? surfel->thickness : 1.0;
    return sum / static_cast<double> (grid.size());
  };
  EXPECT_GT (meanThickness (1), 0.4);
  EXPECT_LT (meanThickness (three_resolutions), 0.2);
}

TEST (OrientedVoxels, TakeTheCoarserNeighborhoodThatTheyLieIn)
{
  // Noise hides the finest neighborhood, on a floor and on a wall far from the floor.
  const Surface far_wall = {{4, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  const VoxelGrid grid =
      connectedGrid (gridsOf ({floor_of_the_scene, far_wall}, 200, 5_cm), 0.05);
  const auto surfels = findSurfels (grid, three_resolutions, 30.0, one_thread);
  std::size_t right = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const bool is_on_wall = grid.moments[i].centroid().x() > 3.0;
    const Eigen::Vector3d normal =
        (is_on_wall ? far_wall : floor_of_the_scene).normal();
    right += surfels[i] && angleBetween (surfels[i]->plane.normal, normal) < 5_deg;
  }
  EXPECT_GT (static_cast<double> (right), 0.9 * static_cast<double> (grid.size()));
}

TEST (OrientedVoxels, HaveNoSurfelOfFewerPointsThanAsked)
{
  // 36 points in a voxel, 324 in a neighborhood of nine.
  for (const std::optional<Surfel>& surfel :
       findSurfels (floorOf (120), 1, 325.0, one_thread))
    EXPECT_FALSE (surfel);
}

TEST (OrientedVoxels, HaveNoSurfelWhereSurfacesAreFinerThanTheirNeighborhoods)
{
  // A roof of many slopes, each as long as a voxel: it is flat within a voxel, but not
  // in a neighborhood.
  Coordinates points = gridsOf ({floor_of_the_scene}, 200);
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] = 0.01f + 0.8f * std::abs (std::remainder (points.x[i], 0.2f));
  const VoxelGrid grid = connectedGrid (points, 10_cm);
  EXPECT_EQ (grid.size(), 400u);
  for (const std::optional<Surfel>& surfel : surfelsOf (grid))
    EXPECT_FALSE (surfel);
}

TEST (OrientedVoxels, HaveASurfelWhereTheVoxelItselfIsAsNoisyAsItsNeighborhood)
{
  // Half as uneven as the roof of the test before, but each point has an offset of its
  // own.
  for (const std::optional<Surfel>& surfel : surfelsOf (floorOf (200, 2_cm)))
    EXPECT_TRUE (surfel);
}

TEST (OrientedVoxels, HaveNoSurfelWhereTheyAreOnAPlaneAlready)
{
  const VoxelGrid grid = floorOf (120);
  pcl_ops::Labels plane_of_voxel (grid.size(), pcl_ops::no_plane);
  std::fill_n (plane_of_voxel.begin(), 100, 0);
  const auto surfels =
      findSurfels (grid, three_resolutions, 30.0, one_thread, plane_of_voxel);
  for (std::size_t i = 0; i < grid.size(); ++i)
    EXPECT_EQ (surfels[i].has_value(), i >= 100);
}

TEST (OrientedVoxels, HaveNoSurfelOnAWire)
{
  // A millimeter wide in voxels of ten centimeters.
  const Surface wire = {{0, 0, 0}, {2, 0, 0}, {0, 1_mm, 0}};
  for (const std::optional<Surfel>& surfel :
       surfelsOf (connectedGrid (gridsOf ({wire}, 120), 10_cm)))
    EXPECT_FALSE (surfel.has_value());
}

TEST (OrientedVoxels, TakeNoNormalOfAPlaneThatTheyAreNotOn)
{
  // Four stray points above a floor: their voxel has the flat floor around it.
  Coordinates points = gridsOf ({{{0, 0, 0.05}, {2, 0, 0}, {0, 2, 0}}}, 120);
  addGrid (points, {{1.0, 1.0, 0.1}, {0.1, 0, 0}, {0, 0.1, 0.1}}, 2);
  const VoxelGrid grid = connectedGrid (points, 10_cm);
  const auto surfels = surfelsOf (grid);
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (surfels[i]) {
      const double max_distance = 1.5 * std::max (surfels[i]->noise, 3_mm);
      EXPECT_LT (meanSquaredDistance (grid.moments[i], surfels[i]->plane),
                 max_distance * max_distance);
    }
}

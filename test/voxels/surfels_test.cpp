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
/** \brief Fewest points of a neighborhood. */
constexpr double usual_min_points = 30.0;

/** \brief Surfels at three resolutions. A neighborhood has 30 points or more, and at
 * least as many as eight voxels hold on average. */
std::vector<std::optional<Surfel>>
surfelsOf (const VoxelGrid& grid)
{
  const double min_points =
      std::max (usual_min_points, 8.0 * meanPointsPerVoxel (grid));
  std::vector<std::optional<Surfel>> surfels =
      findSurfels (grid, three_resolutions, min_points, one_thread);
  EXPECT_FALSE (surfels.empty());
  EXPECT_EQ (surfels.size(), grid.size());
  return surfels;
}

/** \brief Voxels of 10 cm of the floor, which has steps x steps points.
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

/** \brief Whether a normal is more than 5 degrees from those of floor and wall, as if
 * the surface were bent round their edge. */
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
    constexpr double max_angle = 1e-3; // [rad]
    constexpr double max_noise = 1e-5; // [m]
    EXPECT_LT (angleBetween (surfel->plane.normal, board.normal()), max_angle);
    EXPECT_LT (surfel->noise, max_noise);
  }
}

TEST (OrientedVoxels, MeasureTheNoiseAroundThem)
{
  // Offsets drawn uniformly up to 2 cm have a standard deviation of 2 cm / sqrt (3).
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
  // Only the 20 voxels that hold points of both surfaces may have a bent normal.
  EXPECT_LE (bent, 20u);
}

TEST (OrientedVoxels, OfAnEdgeWouldBendWithTheirOwnNeighborhoods)
{
  // The scene of the test before, which would not fail if edges bent no normals.
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
  // The cube fills the eight voxels that meet at its middle. These are neighbors: the
  // neighborhood of each has all points.
  constexpr double edge_of_cube = 40_m;
  constexpr double edge_of_voxel = 20_m;
  constexpr std::size_t points_in_cube = 20000;
  for (const std::optional<Surfel>& surfel : surfelsOf (connectedGrid (
           pointsInACube (points_in_cube, edge_of_cube), edge_of_voxel))) {
    ASSERT_TRUE (surfel);
    EXPECT_GT (surfel->thickness, 0.8) << "a ball has 1";
  }
}

TEST (OrientedVoxels, TakeACoarserNeighborhoodWhereNoiseHidesTheFinest)
{
  // Offsets up to 5 cm, an rms of 3 cm, in voxels of 5 cm: neighborhoods of the finest
  // resolution are thick, those of the coarsest of three are flat.
  const VoxelGrid grid =
      connectedGrid (gridsOf ({floor_of_the_scene}, 200, 5_cm), 5_cm);
  const auto meanThickness = [&grid] (int resolutions) {
    double sum = 0.0;
    for (const std::optional<Surfel>& surfel :
         findSurfels (grid, resolutions, usual_min_points, one_thread))
      sum += surfel ? surfel->thickness : 1.0; // 1 without a surfel, as a ball has
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
      connectedGrid (gridsOf ({floor_of_the_scene, far_wall}, 200, 5_cm), 5_cm);
  const auto surfels =
      findSurfels (grid, three_resolutions, usual_min_points, one_thread);
  std::size_t correct = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const bool is_on_wall = grid.moments[i].centroid().x() > 3.0;
    const Eigen::Vector3d normal =
        (is_on_wall ? far_wall : floor_of_the_scene).normal();
    correct += surfels[i] && angleBetween (surfels[i]->plane.normal, normal) < 5_deg;
  }
  EXPECT_GT (static_cast<double> (correct), 0.9 * static_cast<double> (grid.size()));
}

TEST (OrientedVoxels, HaveNoSurfelOfFewerPointsThanAsked)
{
  // 36 points in a voxel, 324 in a neighborhood of nine.
  constexpr int one_resolution = 1;
  const auto countSurfels = [] (double min_points) {
    std::size_t count = 0;
    for (const std::optional<Surfel>& surfel :
         findSurfels (floorOf (120), one_resolution, min_points, one_thread))
      count += surfel ? 1 : 0;
    return count;
  };
  EXPECT_GT (countSurfels (324.0), 0u);
  EXPECT_EQ (countSurfels (325.0), 0u);
}

TEST (OrientedVoxels, HaveNoSurfelWhereSurfacesAreFinerThanTheirNeighborhoods)
{
  // A zigzag roof of many slopes, each 10 cm long, as a voxel, and 8 cm high: it is
  // flat within a voxel, but not in a neighborhood.
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
  // Offsets spread over 4 cm. Unlike the zigzag roof of the test before, each voxel
  // alone shows this noise.
  for (const std::optional<Surfel>& surfel : surfelsOf (floorOf (200, 2_cm)))
    EXPECT_TRUE (surfel);
}

TEST (OrientedVoxels, HaveNoSurfelWhereTheyAreOnAPlaneAlready)
{
  const VoxelGrid grid = floorOf (120);
  pcl_ops::Labels plane_of_voxel (grid.size(), pcl_ops::no_plane);
  constexpr std::size_t voxels_on_plane = 100; // the first ones, on plane 0
  std::fill_n (plane_of_voxel.begin(), voxels_on_plane, 0);
  const auto surfels = findSurfels (
      grid, three_resolutions, usual_min_points, one_thread, plane_of_voxel);
  for (std::size_t i = 0; i < grid.size(); ++i)
    EXPECT_EQ (surfels[i].has_value(), i >= voxels_on_plane);
}

TEST (OrientedVoxels, HaveNoSurfelOnAWire)
{
  const Surface wire = {{0, 0, 0}, {2, 0, 0}, {0, 1_mm, 0}};
  for (const std::optional<Surfel>& surfel :
       surfelsOf (connectedGrid (gridsOf ({wire}, 120), 10_cm)))
    EXPECT_FALSE (surfel.has_value());
}

TEST (OrientedVoxels, TakeNoNormalOfAPlaneThatTheyAreNotOn)
{
  // Four stray points in a voxel above a floor: the neighborhood of that voxel is flat,
  // but its own points are not on the plane of the floor.
  Coordinates points = gridsOf ({{{0, 0, 0.05}, {2, 0, 0}, {0, 2, 0}}}, 120);
  constexpr int stray_steps = 2;
  addGrid (points, {{1.0, 1.0, 0.1}, {0.1, 0, 0}, {0, 0.1, 0.1}}, stray_steps);
  const VoxelGrid grid = connectedGrid (points, 10_cm);
  const auto surfels = surfelsOf (grid);
  std::size_t count = 0;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (surfels[i]) {
      ++count;
      constexpr double smallest_noise = 3_mm; // 3 % of the voxel size
      // Noises up to 1.5 times as large count as alike.
      const double max_distance = 1.5 * std::max (surfels[i]->noise, smallest_noise);
      EXPECT_LT (meanSquaredDistance (grid.moments[i], surfels[i]->plane),
                 max_distance * max_distance);
    }
  EXPECT_GT (count, 300u) << "of 400 voxels of the floor";
}

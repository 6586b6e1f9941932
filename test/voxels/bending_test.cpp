// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/bending.h"

using pcl_ops::fitPlane;
using pcl_ops::PlaneFit;
using namespace pcl_ops::internal;

namespace {

/** \brief Returns the height of a surface at (x, y) [m]. */
using HeightFunction = double (*) (double x, double y);

/** \brief 200 x 200 points of a surface above a square around the origin, in voxels of
 * 10 cm.
 * \param[in] half_edge x and y of the square go from -half_edge to half_edge [m]
 * \param[in] max_offset each point is moved up or down by up to this much [m] */
VoxelGrid
gridOver (double half_edge, double max_offset, HeightFunction heightAt)
{
  const Surface square{
      {-half_edge, -half_edge, 0}, {2 * half_edge, 0, 0}, {0, 2 * half_edge, 0}};
  Coordinates points = gridsOf ({square}, 200, max_offset);
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] += static_cast<float> (heightAt (points.x[i], points.y[i]));
  return connectedGrid (points, 10_cm);
}

/** \brief The bending of the first voxels of a grid. */
Bending
bendingOfFirst (std::size_t voxel_count, const VoxelGrid& grid)
{
  const Indices voxels = upTo (voxel_count);
  const std::optional<PlaneFit> fit = fitPlane (momentsOf (grid.moments, voxels));
  EXPECT_TRUE (fit);
  return bendingOf (grid, voxels, *fit);
}

Bending
bendingOfAll (const VoxelGrid& grid)
{
  return bendingOfFirst (grid.size(), grid);
}

const HeightFunction slope = [] (double x, double y) { return 0.3 * x - 0.2 * y; };
/** \brief The top of a cylinder along y with a radius of 1 m. */
const HeightFunction barrel = [] (double x, double) { return std::sqrt (1.0 - x * x); };
/** \brief The top of a ball with a radius of 1 m. */
const HeightFunction ball = [] (double x, double y) {
  return std::sqrt (1.0 - x * x - y * y);
};
const HeightFunction saddle = [] (double x, double y) { return 0.5 * x * y; };
const HeightFunction parabola = [] (double x, double) { return 0.1 * x * x; };
/** \brief 5 mm high in the middle, 0 at x = 2 m and x = -2 m. */
const HeightFunction bowed_wall = [] (double x, double) {
  return 5_mm * (1.0 - x * x / 4.0);
};

} // namespace

TEST (Bending, ExplainsNothingOfANoisyPlane)
{
  const Bending bending = bendingOfAll (gridOver (50_cm, 1_cm, slope));
  EXPECT_LT (bending.explained_share, 20_percent);
  EXPECT_LT (bending.amplitude, 2_mm);
  EXPECT_FALSE (isCurved (bending));
}

TEST (Bending, ExplainsCylindersAndBallsAndSaddles)
{
  for (const HeightFunction surface : {barrel, ball, saddle}) {
    const Bending bending = bendingOfAll (gridOver (50_cm, 5_mm, surface));
    EXPECT_GT (bending.explained_share, 90_percent);
    EXPECT_TRUE (isCurved (bending));
  }
}

TEST (Bending, IsAsFarAsTheSurfaceBends)
{
  // The height is 0.1 x^2 / m: 25 mm at either end, x = 50 cm and x = -50 cm.
  const Bending bending = bendingOfAll (gridOver (50_cm, 0.0, parabola));
  EXPECT_NEAR (bending.amplitude, 25_mm, 1_mm);
  EXPECT_NEAR (bending.half_extent, 50_cm, 2_cm);
}

TEST (Bending, OfASlightlyBowedWallIsNoCurvature)
{
  const Bending exact = bendingOfAll (gridOver (2_m, 0.0, bowed_wall));
  EXPECT_GT (exact.explained_share, 90_percent) << "second-order terms explain the bow";
  EXPECT_FALSE (isCurved (exact));
  EXPECT_FALSE (isCurved (bendingOfAll (gridOver (2_m, 1_cm, bowed_wall))));
}

TEST (Bending, ThatExplainsLittleOfTheUnevennessIsNoCurvature)
{
  Bending bending = bendingOfAll (gridOver (50_cm, 0.0, barrel));
  ASSERT_TRUE (isCurved (bending));
  bending.explained_share = 30_percent; // isCurved asks for 40 %
  EXPECT_FALSE (isCurved (bending));
}

TEST (Bending, IsOfEightVoxelsOrMore)
{
  const VoxelGrid grid = gridOver (50_cm, 0.0, barrel);
  EXPECT_EQ (bendingOfFirst (7, grid).explained_share, 0.0);
  EXPECT_EQ (bendingOfFirst (7, grid).amplitude, 0.0);
  EXPECT_FALSE (isCurved (bendingOfFirst (7, grid)));
  EXPECT_GT (bendingOfFirst (8, grid).amplitude, 0.0);
}

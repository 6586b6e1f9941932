// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/bending.h"

using pcl_ops::fitPlane;
using pcl_ops::PlaneFit;
using namespace pcl_ops::internal;

namespace {

/** \brief Height of a surface at (x, y) [m]. */
using Height = double (*) (double x, double y);

/** \brief Points above a square of 200 x 200, in voxels of 10 cm.
 * \param[in] heightAt x and y, both from -half_edge to half_edge [m]
 * \param[in] noise each point is moved up or down by up to this much [m] */
VoxelGrid
gridOver (double half_edge, double noise, Height heightAt)
{
  const Surface square{
      {-half_edge, -half_edge, 0}, {2 * half_edge, 0, 0}, {0, 2 * half_edge, 0}};
  Coordinates points = gridsOf ({square}, 200, noise);
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] += static_cast<float> (heightAt (points.x[i], points.y[i]));
  return connectedGrid (points, 10_cm);
}

/** \brief The bending of the first voxels of a grid, or of all of them. */
Bending
bendingOfAll (const VoxelGrid& grid, std::size_t number = 1000000)
{
  const Indices voxels = upTo (std::min (number, grid.size()));
  const std::optional<PlaneFit> fit = fitPlane (momentsOf (grid.moments, voxels));
  EXPECT_TRUE (fit);
  return bendingOf (grid, voxels, *fit);
}

const Height slope = [] (double x, double y) { return 0.3 * x - 0.2 * y; };
const Height barrel = [] (double x, double) { return std::sqrt (1.0 - x * x); };
const Height ball = [] (double x, double y) { return std::sqrt (1.0 - x * x - y * y); };
const Height saddle = [] (double x, double y) { return 0.5 * x * y; };
/** \brief Up to 5 mm in the middle of 4 m. */
const Height bowed_wall = [] (double x, double) { return 5_mm * (1.0 - x * x / 4.0); };

} // namespace

TEST (Bending, ExplainsNothingOfANoisyPlane)
{
  const Bending bending = bendingOfAll (gridOver (50_cm, 1_cm, slope));
  EXPECT_LT (bending.explained, 20_percent);
  EXPECT_LT (bending.amplitude, 2_mm);
  EXPECT_FALSE (isCurved (bending));
}

TEST (Bending, ExplainsCylindersAndBallsAndSaddles)
{
  for (const Height surface : {barrel, ball, saddle}) {
    const Bending bending = bendingOfAll (gridOver (50_cm, 5_mm, surface));
    EXPECT_GT (bending.explained, 90_percent);
    EXPECT_TRUE (isCurved (bending));
  }
}

TEST (Bending, IsAsFarAsTheSurfaceBends)
{
  // 0.1 x^2 for x up to 50 cm: 25 mm at either end, in the direction of x.
  const Bending bending = bendingOfAll (
      gridOver (50_cm, 0.0, [] (double x, double) { return 0.1 * x * x; }));
  EXPECT_NEAR (bending.amplitude, 25_mm, 1_mm);
  EXPECT_NEAR (bending.half_extent, 50_cm, 2_cm);
}

TEST (Bending, OfASlightlyBowedWallIsNoCurvature)
{
  const Bending exact = bendingOfAll (gridOver (2_m, 0.0, bowed_wall));
  EXPECT_GT (exact.explained, 90_percent) << "it is bowed all the same";
  EXPECT_FALSE (isCurved (exact));
  EXPECT_FALSE (isCurved (bendingOfAll (gridOver (2_m, 1_cm, bowed_wall))));
}

TEST (Bending, ThatExplainsLittleOfTheUnevennessIsNoCurvature)
{
  Bending bending = bendingOfAll (gridOver (50_cm, 0.0, barrel));
  ASSERT_TRUE (isCurved (bending));
  bending.explained = 30_percent;
  EXPECT_FALSE (isCurved (bending));
}

TEST (Bending, IsOfEightVoxelsOrMore)
{
  const VoxelGrid grid = gridOver (50_cm, 0.0, barrel);
  EXPECT_EQ (bendingOfAll (grid, 7).explained, 0.0);
  EXPECT_EQ (bendingOfAll (grid, 7).amplitude, 0.0);
  EXPECT_FALSE (isCurved (bendingOfAll (grid, 7)));
  EXPECT_GT (bendingOfAll (grid, 8).amplitude, 0.0);
}

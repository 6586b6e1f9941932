// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "buildings/covered_squares.h"
#include "scene.h"

using namespace pcl_ops::internal::buildings;
using Eigen::Vector2d;

namespace {

/** \brief The share of a cell of 0.8 m x 2 m that squares of 10 cm cover.
 * \param[in] cell_begin its smallest x [m]
 * \param[in] spacing of points on a floor from (0, 0) to (\p floor_end, 4 m) */
double
coveredShare (double cell_begin, double spacing, double floor_end)
{
  PlanPoints points;
  for (double x = 0.5 * spacing; x < floor_end; x += spacing)
    for (double y = 0.5 * spacing; y < 4.0; y += spacing)
      points.emplace_back (x, y, 0.0);
  const CoveredSquares squares (points, {Vector2d (0, 0), Vector2d (4, 4)}, 10_cm);
  const double cell_end = cell_begin + 0.8;
  PlanCell cell;
  cell.corners = {{cell_begin, 1}, {cell_end, 1}, {cell_end, 3}, {cell_begin, 3}};
  return squares.coveredShareOf (cell);
}

} // namespace

TEST (CoveredSquares, AreThoseBetweenPointsFartherApartThanSquaresAreWide)
{
  EXPECT_EQ (coveredShare (1_m, 15_cm, 3_m), 1.0);
  EXPECT_LT (coveredShare (1_m, 40_cm, 3_m), 0.2) << "a few points are no floor";
}

TEST (CoveredSquares, AreNoneBesideADenseFloor)
{
  // The last squares of the floor, from x = 2 m on, have points in their first 3 cm.
  EXPECT_EQ (coveredShare (2.1, 3_cm, 2.03), 0.0);
  EXPECT_EQ (coveredShare (1.2, 3_cm, 2.03), 1.0);
}

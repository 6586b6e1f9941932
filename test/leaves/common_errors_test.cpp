// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/common_errors.h"

using namespace pcl_ops::internal;

namespace {

/** \brief In leaves of 20 cm, whose places are 80 cm wide.
 * \param[in] noise_of_level of cells of 10 cm, and of twice the edge each [m] */
double
shareOf (const Coordinates& positions, const std::vector<double>& noise_of_level)
{
  const CurvePoints points = sortAlongCurve (positions, finest_cell, 1);
  const std::vector<CellScatter> cells = scatterOfCells (points, 1);
  std::vector<CellScatter> expected;
  int level = level_of_10_cm;
  for (const double noise : noise_of_level) {
    for (const CellScatter& cell : cellsOfNoise (noise, 36, level))
      expected.push_back (cell);
    ++level;
  }
  const LeafSizes sizes{level_of_10_cm + 1, level_of_10_cm + 1, 0.0};
  const UnevenNoise uneven (points, cells, level_of_10_cm + 3);
  return shareOfCommonErrors (
      points, cells, {expected, finest_cell}, divideIntoLeaves (points, sizes, uneven));
}

} // namespace

TEST (CommonErrors, AreWhereSurfacesAreUneven)
{
  const Coordinates points = checkerboard (1_cm, before (1.2));
  EXPECT_NEAR (shareOf (points, {1_cm, 1_cm, 1_cm, 1_cm}), 0.6, 0.05);
}

TEST (CommonErrors, AreNoneOnSurfacesThatScatterTheMoreTheLargerOneLooks)
{
  const Coordinates points = checkerboard (1_cm, before (1.2));
  EXPECT_EQ (shareOf (points, {1_mm, 1_cm, 10_cm, 100_cm}), 0.0);
}

TEST (CommonErrors, AreNoneOfWhiteNoise)
{
  EXPECT_EQ (shareOf (gridsOf ({ground}, 120, 1_cm), {1_cm, 1_cm, 1_cm, 1_cm}), 0.0);
}

TEST (CommonErrors, AreOnTheStepsOfAQuantizedDepth)
{
  // Steps of 20 cm, each 5 mm above the last.
  const Coordinates points = pointsOver (1.0, 0.0, [] (double x, double) {
    return 10_cm + 5_mm * std::floor (x / 20_cm);
  });
  EXPECT_GT (shareOf (points, {5_mm, 5_mm, 5_mm, 5_mm}), 0.75);
}

TEST (CommonErrors, AreNoneOnAPlaneWithoutNoise)
{
  EXPECT_EQ (shareOf (gridsOf ({ground}, 120), {1_mm, 1_mm, 1_mm, 1_mm}), 0.0);
}

TEST (CommonErrors, AreNoneWithoutPoints) { EXPECT_EQ (shareOf ({}, {1_mm}), 0.0); }

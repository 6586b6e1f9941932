// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/uneven_noise.h"

using namespace pcl_ops::internal;

namespace {

/** \brief Places of 80 cm, which begin at 40 cm and 1.2 m: 16 cells of 20 cm on a
 * ground. */
constexpr int level_of_place = level_of_10_cm + 3;

/** \brief The unevenness of cells of 20 cm at a place on the ground. */
float
unevennessAt (const Coordinates& positions, const Eigen::Vector3d& place)
{
  const CurvePoints points = sortAlongCurve (positions, finest_cell, 1);
  const UnevenNoise noise (points, scatterOfCells (points, 1), level_of_place);
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if ((points[i] - place).norm() < (points[nearest] - place).norm())
      nearest = i;
  return noise.of (points.code[nearest], level_of_10_cm + 1);
}

} // namespace

TEST (UnevenNoise, IsThatOfThePlace)
{
  const Coordinates points = checkerboard (1_cm, before (1.2));
  EXPECT_NEAR (unevennessAt (points, {0.5, 1.1, 0.05}), 1_cm, 1_mm);
  EXPECT_NEAR (unevennessAt (points, {1.5, 1.1, 0.05}), 0.0, 0.1e-3);
}

TEST (UnevenNoise, OfAPlaceIsThatOfItsFlatterCells)
{
  // Of the 16 cells of a place every second column is even.
  const Coordinates points = checkerboard (
      1_cm, [] (const auto& at) { return std::fmod (at.x(), 0.4) < 0.2; });
  EXPECT_LT (unevennessAt (points, {0.5, 1.1, 0.05}), 1_mm);
}

TEST (UnevenNoise, IsNoneWhereTooFewCellsTell)
{
  const Coordinates points = checkerboard (1_cm, anywhere);
  Coordinates few;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.x[i] < 0.4 && points.y[i] < 0.4)
      few.add (points.x[i], points.y[i], points.z[i]);
  EXPECT_EQ (unevennessAt (few, {0.1, 0.1, 0.05}), 0.0f);
  EXPECT_EQ (unevennessAt (gridsOf ({ground}, 3), {1, 1, 0.05}), 0.0f);
}

TEST (UnevenNoise, IsNoneBeyondTheCloud)
{
  const CurvePoints points =
      sortAlongCurve (checkerboard (1_cm, anywhere), finest_cell, 1);
  const UnevenNoise noise (points, scatterOfCells (points, 1), level_of_place);
  for (const int cells : {-5000, 5000})
    EXPECT_EQ (noise.of (mortonCode (cells, cells, cells), level_of_place), 0.0f);
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"

using namespace pcl_ops::internal;

namespace {

std::vector<CellScatter>
scatterOf (const Coordinates& points)
{
  return scatterOfCells (sortAlongCurve (points, finest_cell, 1));
}

/** \brief Cells of 20 cm. */
std::vector<CellScatter>
cellsOf20cm (const Coordinates& points)
{
  std::vector<CellScatter> cells;
  for (const CellScatter& cell : scatterOf (points))
    if (cell.level == level_of_10_cm + 1)
      cells.push_back (cell);
  return cells;
}

bool
isNowhere (const Eigen::Vector3d&)
{
  return false;
}

} // namespace

TEST (CellScatter, OfAnExactPlaneIsNone)
{
  const auto cells = cellsOf20cm (checkerboard (0.0, isNowhere));
  EXPECT_EQ (cells.size(), 100u);
  for (const CellScatter& cell : cells) {
    EXPECT_TRUE (cell.is_wide);
    EXPECT_EQ (cell.count, 144u);
    EXPECT_LT (cell.noise, 1e-6);
    EXPECT_LT (cell.unevenness, 1e-6);
  }
}

TEST (CellScatter, OfWhiteNoiseIsNotUneven)
{
  // Evenly up to 1 cm: an rms of 5.8 mm.
  double noise = 0.0, unevenness = 0.0;
  const auto cells = cellsOf20cm (gridsOf ({ground}, 120, 1_cm));
  ASSERT_EQ (cells.size(), 100u);
  for (const CellScatter& cell : cells) {
    noise += 1e-2 * cell.noise;
    unevenness += 1e-2 * cell.unevenness;
  }
  EXPECT_NEAR (noise, 5.8e-3, 0.3e-3);
  EXPECT_LT (unevenness, 0.15e-3) << "of 144 points each";
}

TEST (CellScatter, IsAsUnevenAsTheBumpsOfTheSizeOfItsEighths)
{
  const auto cells = cellsOf20cm (checkerboard (1_cm, anywhere));
  EXPECT_EQ (cells.size(), 100u);
  for (const CellScatter& cell : cells) {
    EXPECT_NEAR (cell.unevenness, 1_cm, 1_mm);
    EXPECT_NEAR (cell.noise, 1_cm, 1_mm);
  }
}

TEST (CellScatter, OfANarrowStripIsNotWide)
{
  const Surface strip = {{0, 0.01, 0.05}, {2, 0, 0}, {0, 0.02, 0}};
  const auto cells = cellsOf20cm (gridsOf ({strip}, 120));
  EXPECT_EQ (cells.size(), 10u);
  for (const CellScatter& cell : cells)
    EXPECT_FALSE (cell.is_wide);
}

TEST (CellScatter, NeedsMorePointsThanAPlane)
{
  const Surface tile = {{0, 0, 0.05}, {0.2, 0, 0}, {0, 0.2, 0}};
  EXPECT_TRUE (scatterOf (gridsOf ({tile}, 2)).empty());
  EXPECT_FALSE (scatterOf (gridsOf ({tile}, 6)).empty());
  EXPECT_TRUE (scatterOf (Coordinates()).empty());
}

TEST (CellScatter, OfACellComesAfterThoseOfTheCellsInIt)
{
  // Each cell follows smaller ones that it holds, or lies behind the cell before it.
  const auto cells = scatterOf (gridsOf ({ground}, 120));
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const std::uint32_t end = cells[i].begin + cells[i].count;
    const bool holds_the_one_before = cells[i].begin <= cells[i - 1].begin;
    EXPECT_TRUE (holds_the_one_before ||
                 cells[i].begin >= cells[i - 1].begin + cells[i - 1].count);
    EXPECT_LE (cells[i - 1].begin, end);
    EXPECT_TRUE (!holds_the_one_before || cells[i - 1].level < cells[i].level);
  }
  EXPECT_EQ (cells.back().count, 14400u);
}

TEST (CellScatter, IsMeasuredOfManyCells)
{
  // More cells than a batch of the measurement holds (512).
  const auto cells = scatterOf (gridsOf ({ground}, 360, 1_cm));
  EXPECT_GT (cells.size(), 1600u);
  for (const CellScatter& cell : cells)
    EXPECT_GT (cell.noise, 0.0f);
}

TEST (Density, IsThatOfFourTimesThePointsInTwiceTheEdge)
{
  EXPECT_DOUBLE_EQ (densityOf (7, 3), densityOf (28, 4));
  EXPECT_DOUBLE_EQ (densityOf (14, 3), densityOf (7, 3) + 1.0);
}

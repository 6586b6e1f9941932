// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/cell_scatter.h"

using namespace pcl_ops::internal;

namespace {

/** \brief The scatter of the cells of all sizes. */
std::vector<CellScatter>
scatterOf (const Coordinates& points)
{
  return scatterOfCells (sortAlongCurve (points, finest_cell, 1), 2);
}

/** \brief The scatter of the cells of 20 cm: 100 of them on the ground of 2 m x 2 m,
 * with 144 of its 120 x 120 points each. */
std::vector<CellScatter>
cellsOf20cm (const Coordinates& points)
{
  std::vector<CellScatter> cells;
  for (const CellScatter& cell : scatterOf (points))
    if (cell.level == level_of_10_cm + 1)
      cells.push_back (cell);
  return cells;
}

} // namespace

TEST (CellScatter, OfAnExactPlaneIsNone)
{
  const auto cells = cellsOf20cm (gridsOf ({ground}, 120));
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
  // Noise that is spread evenly up to 1 cm has an rms of 1 cm / sqrt (3) = 5.8 mm.
  double noise = 0.0;
  double unevenness = 0.0;
  const auto cells = cellsOf20cm (gridsOf ({ground}, 120, 1_cm));
  ASSERT_EQ (cells.size(), 100u);
  for (const CellScatter& cell : cells) {
    noise += 1e-2 * cell.noise;
    unevenness += 1e-2 * cell.unevenness;
  }
  EXPECT_NEAR (noise, 5.8e-3, 0.3e-3);
  EXPECT_LT (unevenness, 0.15e-3);
}

TEST (CellScatter, OfWhiteNoiseBetweenUpperAndLowerEighthsIsNotUneven)
{
  // Half of the noise is above the middle of the cells, in eighths of its own.
  const Surface between = {{0, 0, 0.1}, {2, 0, 0}, {0, 2, 0}};
  for (const CellScatter& cell : cellsOf20cm (gridsOf ({between}, 120, 1_cm)))
    EXPECT_LT (cell.unevenness, 2_mm);
}

TEST (CellScatter, IsAsUnevenAsTheBumpsOfTheSizeOfItsEighths)
{
  // Squares of 10 cm, a quarter of such a cell, are 1 cm higher and lower in turn.
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

TEST (CellScatter, OfCellsThatHoldOthersComesAfterTheirsAndHasAllPoints)
{
  // 51 m wide: cells of up to 26 m are looked at independently of each other.
  const Surface site = {{0.1, 0.1, 0.1}, {51, 0, 0}, {0, 51, 0}};
  const CurvePoints points = sortAlongCurve (gridsOf ({site}, 120), finest_cell, 1);
  const std::vector<CellScatter> cells = scatterOfCells (points, 2);
  ASSERT_FALSE (cells.empty());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].level < 8)
      continue; // the many small ones
    EXPECT_TRUE (std::none_of (cells.begin() + static_cast<std::ptrdiff_t> (i) + 1,
                               cells.end(),
                               [&] (const CellScatter& later) {
                                 return later.begin >= cells[i].begin &&
                                        later.begin + later.count <=
                                            cells[i].begin + cells[i].count;
                               }));
  }
  EXPECT_GT (cells.back().level, 10);
  EXPECT_EQ (cells.back().count, points.size());
}

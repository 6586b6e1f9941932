// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"

using namespace pcl_ops::internal;

namespace {

constexpr double huge_noise = 1e6;

/** \brief Where a leaf of 10 cm holds so many points. */
double
densityOf10cm (double points)
{
  return densityOf (points, level_of_10_cm);
}

/** \brief Cells of 36 points in 10 cm: a noise for each level from that of 10 cm on. */
std::vector<CellScatter>
cellsOfLevels (const std::vector<double>& noises)
{
  std::vector<CellScatter> cells;
  int level = level_of_10_cm;
  for (const double noise : noises) {
    const auto of_level = cellsOfNoise (noise, 36, level);
    cells.insert (cells.end(), of_level.begin(), of_level.end());
    ++level;
  }
  return cells;
}

/** \brief Expected noise of a plane with 36 points in 10 cm that is as large as a cell.
 * \param[in] level of the cell; 0 is 10 cm, -1 is 5 cm */
double
noiseOfSize (const ExpectedNoise& noise, int level)
{
  return noise.of (densityOf10cm (36), 36 * std::pow (4.0, level));
}

} // namespace

TEST (ExpectedNoise, OfWhiteNoiseIsTheSameForAllSizes)
{
  const ExpectedNoise noise (cellsOfLevels ({5_mm, 5_mm, 5_mm, 5_mm}), finest_cell);
  for (const int level : {-1, 0, 1, 2, 3})
    EXPECT_NEAR (noiseOfSize (noise, level), 5_mm, 1e-6);
}

TEST (ExpectedNoise, GrowsWithTheSizeWhereThatOfCellsDoes)
{
  const ExpectedNoise noise (cellsOfLevels ({4_mm, 5_mm, 6_mm, 7_mm}), finest_cell);
  for (const int level : {0, 1, 2, 3})
    EXPECT_NEAR (noiseOfSize (noise, level), (4 + level) * 1_mm, 0.1e-3);
}

TEST (ExpectedNoise, TellsDensePointsFromSparseOnes)
{
  std::vector<CellScatter> cells = cellsOfNoise (1_mm, 1000, level_of_10_cm);
  for (const CellScatter& cell : cellsOfNoise (2_cm, 10, level_of_10_cm))
    cells.push_back (cell);
  const ExpectedNoise noise (cells, finest_cell);
  EXPECT_NEAR (noise.of (densityOf10cm (1000), 1000), 1_mm, 0.1e-3);
  EXPECT_NEAR (noise.of (densityOf10cm (10), 10), 2_cm, 2_mm);
}

TEST (ExpectedNoise, IsThatOfTheNearestDensityWhichIsKnown)
{
  std::vector<CellScatter> cells = cellsOfNoise (1_mm, 4096, level_of_10_cm);
  for (const CellScatter& cell : cellsOfNoise (2_cm, 8, level_of_10_cm))
    cells.push_back (cell);
  const ExpectedNoise noise (cells, finest_cell);
  EXPECT_NEAR (noise.of (densityOf10cm (1500), 1500), 1_mm, 0.1e-3);
  EXPECT_NEAR (noise.of (densityOf10cm (20), 20), 2_cm, 2_mm);
}

TEST (ExpectedNoise, IsLargerThanAnyCloudWhereNoCellTells)
{
  std::vector<CellScatter> narrow = cellsOfNoise (1_mm, 36, level_of_10_cm);
  for (CellScatter& cell : narrow)
    cell.is_wide = false;
  constexpr int too_few = 5;
  for (const auto& cells : {std::vector<CellScatter>(),
                            cellsOfNoise (1_mm, 36, level_of_10_cm, too_few),
                            narrow}) {
    const ExpectedNoise noise (cells, finest_cell);
    EXPECT_GT (noise.of (densityOf10cm (36), 36), huge_noise);
    EXPECT_GT (noise.lowest (densityOf10cm (36)), huge_noise);
  }
}

TEST (ExpectedNoise, IsThatOfTheFlattestCells)
{
  std::vector<CellScatter> cells = cellsOfNoise (1_mm, 36, level_of_10_cm, 50);
  for (const CellScatter& bush : cellsOfNoise (5_cm, 36, level_of_10_cm, 150))
    cells.push_back (bush);
  EXPECT_NEAR (noiseOfSize (ExpectedNoise (cells, finest_cell), 0), 1_mm, 1e-6);
}

TEST (ExpectedNoise, IsNotTakenFromWhatBends)
{
  // Four times as much for twice the size, as a curve of one radius has it.
  const ExpectedNoise noise (cellsOfLevels ({1_mm, 1_mm, 4_mm, 16_mm}), finest_cell);
  EXPECT_NEAR (noiseOfSize (noise, 1), 1_mm, 1e-6);
  EXPECT_LT (noiseOfSize (noise, 2), 2_mm);
  EXPECT_LT (noiseOfSize (noise, 3), 4_mm);
}

TEST (ExpectedNoise, GrowsSlowlyBeyondTheLargestCellsThatTell)
{
  const ExpectedNoise noise (cellsOfLevels ({1_mm}), finest_cell);
  EXPECT_GT (noiseOfSize (noise, 2), 1.1e-3);
  EXPECT_LT (noiseOfSize (noise, 2), 4_mm);
}

TEST (ExpectedNoise, IsNotTakenFromTheStepsOfAQuantizedDepth)
{
  const ExpectedNoise noise (cellsOfLevels ({0_mm, 0_mm, 4_mm, 4_mm}), finest_cell);
  for (const int level : {0, 1, 2, 3})
    EXPECT_NEAR (noiseOfSize (noise, level), 4_mm, 1e-6);
}

TEST (ExpectedNoise, HasABoundThatIsNotAboveItAndNotFarBelow)
{
  const ExpectedNoise noise (cellsOfLevels ({2_mm, 3_mm, 4_mm}), finest_cell);
  for (const double points : {10, 36, 1000})
    for (const int level : {-2, 0, 1, 5}) {
      const double density = densityOf10cm (points);
      EXPECT_LE (noise.lowest (density), noise.of (density, std::pow (4.0, level)));
    }
  EXPECT_NEAR (noise.lowest (densityOf10cm (36)), 2_mm, 0.1e-3);
}

TEST (ExpectedNoise, IsNoiseUpToTheSizeFromWhichItMoreThanDoubles)
{
  const ExpectedNoise noise (cellsOfLevels ({4_mm, 5_mm, 6_mm, 60_mm}), finest_cell);
  EXPECT_TRUE (noise.isNoise (densityOf10cm (36), level_of_10_cm + 2));
  EXPECT_FALSE (noise.isNoise (densityOf10cm (36), level_of_10_cm + 3));
}

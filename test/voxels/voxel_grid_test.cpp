// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include <pcl_ops/cell_grid.h>

#include <numeric>

using pcl_ops::CellGrid;
using pcl_ops::CellKey;
using pcl_ops::Coordinates;
using pcl_ops::GriddedPoints;

namespace {

Coordinates
pointsInACube (std::size_t number, double edge)
{
  pcl_ops::RandomGenerator generator (seedOfTest());
  const auto draw = [&] {
    return static_cast<float> (edge * (pcl_ops::drawUnit (generator) - 0.5));
  };
  Coordinates points;
  for (std::size_t i = 0; i < number; ++i) {
    const float x = draw(), y = draw(), z = draw();
    points.add (x, y, z);
  }
  return points;
}

bool
isNeighbour (const CellKey& a, const CellKey& b)
{
  return std::abs (a.x - b.x) <= 1 && std::abs (a.y - b.y) <= 1 &&
         std::abs (a.z - b.z) <= 1;
}

double
countOf (const CellGrid& grid)
{
  double count = 0.0;
  for (const pcl_ops::Moments& cell : grid.moments)
    count += cell.count;
  return count;
}

} // namespace

TEST (CellGrid, SharesACellBetweenPointsOfTheSameCubeOnly)
{
  Coordinates points;
  points.add (0.2f, 0.2f, 0.2f);
  points.add (0.8f, 0.8f, 0.8f);
  points.add (-0.2f, 0.2f, 0.2f);
  const GriddedPoints gridded = pcl_ops::gridPoints (points, 1.0, 1);
  EXPECT_EQ (gridded.grid.size(), 2u);
  EXPECT_EQ (gridded.cell_of_point[0], gridded.cell_of_point[1]);
  EXPECT_NE (gridded.cell_of_point[0], gridded.cell_of_point[2]);
}

TEST (CellGrid, AddsUpTheMomentsOfTheCellsPoints)
{
  const Coordinates points = pointsInACube (5000, 4.0);
  const GriddedPoints gridded = pcl_ops::gridPoints (points, 0.5, 1);
  std::vector<pcl_ops::Moments> expected (gridded.grid.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    expected[gridded.cell_of_point[i]].add (points.x[i], points.y[i], points.z[i]);
  for (std::size_t c = 0; c < expected.size(); ++c) {
    EXPECT_EQ (gridded.grid.moments[c].count, expected[c].count);
    EXPECT_LT ((gridded.grid.moments[c].sum - expected[c].sum).norm(), 1e-9);
  }
}

TEST (CellGrid, KnowsEveryOccupiedNeighbourAsBruteForceDoes)
{
  const CellGrid grid = pcl_ops::gridPoints (pointsInACube (400, 9.0), 0.5, 1).grid;
  for (std::size_t a = 0; a < grid.size(); ++a) {
    std::vector<std::uint32_t> expected;
    for (std::size_t b = 0; b < grid.size(); ++b)
      if (isNeighbour (grid.keys[a], grid.keys[b]))
        expected.push_back (static_cast<std::uint32_t> (b));
    std::vector<std::uint32_t> found (grid.neighbours[a].begin(),
                                      grid.neighbours[a].end());
    std::sort (found.begin(), found.end());
    ASSERT_EQ (found, expected);
  }
}

TEST (CellGrid, DoesNotDependOnTheOrderOfThePoints)
{
  const Coordinates points = pointsInACube (3000, 4.0);
  Coordinates reversed;
  for (std::size_t i = points.size(); i-- > 0;)
    reversed.add (points.x[i], points.y[i], points.z[i]);
  const CellGrid first = pcl_ops::gridPoints (points, 0.5, 1).grid;
  const CellGrid second = pcl_ops::gridPoints (reversed, 0.5, 1).grid;
  ASSERT_EQ (first.size(), second.size());
  for (std::size_t c = 0; c < first.size(); ++c) {
    EXPECT_EQ (first.keys[c].x, second.keys[c].x);
    EXPECT_EQ (first.moments[c].count, second.moments[c].count);
  }
}

TEST (CellGrid, IsTheSameForAnyNumberOfThreads)
{
  const Coordinates points = pointsInACube (400000, 4.0);
  const GriddedPoints one = pcl_ops::gridPoints (points, 0.2, 1);
  for (const unsigned threads : {2u, 3u, 4u, 8u}) {
    const GriddedPoints many = pcl_ops::gridPoints (points, 0.2, threads);
    EXPECT_EQ (one.cell_of_point, many.cell_of_point);
    for (std::size_t c = 0; c < one.grid.size(); ++c)
      ASSERT_EQ (one.grid.moments[c].sum, many.grid.moments[c].sum);
  }
}

TEST (CellGrid, KeepsStrayPointsFarAway)
{
  Coordinates points = pointsInACube (100, 1.0);
  points.add (1e9f, -1e9f, 1e9f);
  const GriddedPoints gridded = pcl_ops::gridPoints (points, 0.1, 1);
  EXPECT_EQ (countOf (gridded.grid), 101.0);
}

TEST (CoarserGrid, HoldsEightCellsEachAndLosesNoPoint)
{
  const CellGrid fine = pcl_ops::gridPoints (pointsInACube (3000, 4.0), 0.25, 1).grid;
  const pcl_ops::CoarserGrid coarser = pcl_ops::coarsen (fine, 1);
  EXPECT_EQ (coarser.grid.cell_size, 0.5);
  EXPECT_EQ (countOf (coarser.grid), countOf (fine));
  for (std::size_t c = 0; c < fine.size(); ++c) {
    const CellKey& parent = coarser.grid.keys[coarser.cell_of_finer[c]];
    EXPECT_EQ (parent.x, fine.keys[c].x >> 1);
    EXPECT_EQ (parent.z, fine.keys[c].z >> 1);
  }
}

TEST (CellSize, FillsAboutAsManyCellsAsWanted)
{
  Coordinates points;
  addGrid (points, {{0, 0, 0}, {5, 0, 0}, {0, 4, 0}}, 400);
  for (const double wanted : {300.0, 2000.0, 10000.0}) {
    const double size = pcl_ops::cellSizeFor (points, wanted);
    const auto cells =
        static_cast<double> (pcl_ops::gridPoints (points, size, 1).grid.size());
    EXPECT_NEAR (cells / wanted, 1.0, 0.35) << wanted;
  }
}

TEST (CellSize, GrowsWithTheUnitOfTheCloud)
{
  Coordinates metres, millimetres;
  addGrid (metres, {{0, 0, 0}, {5, 0, 0}, {0, 4, 0}}, 200);
  addGrid (millimetres, {{0, 0, 0}, {5000, 0, 0}, {0, 4000, 0}}, 200);
  EXPECT_NEAR (pcl_ops::cellSizeFor (millimetres, 1000.0) /
                   pcl_ops::cellSizeFor (metres, 1000.0),
               1000.0,
               100.0);
}

TEST (CellSize, IsZeroForPointsThatSpanNothing)
{
  Coordinates equal;
  EXPECT_EQ (pcl_ops::cellSizeFor (equal, 100.0), 0.0);
  equal.add (1.0f, 2.0f, 3.0f);
  equal.add (1.0f, 2.0f, 3.0f);
  EXPECT_EQ (pcl_ops::cellSizeFor (equal, 100.0), 0.0);
}

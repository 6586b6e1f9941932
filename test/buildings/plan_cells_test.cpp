// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "buildings/plan_cells.h"
#include "buildings/planar_area.h"

#include <algorithm>
#include <cmath>

using namespace pcl_ops::internal::buildings;
using Eigen::Vector2d;

namespace {

/** \brief A rim of 4 m x 3 m that is not at zero. */
const pcl_ops::PlanarPoints rim_of_plan = {{10, 20}, {14, 20}, {14, 23}, {10, 23}};
// PlanLine is a point of the line and its direction.
const PlanLine line_across = {{11, 0}, {0, 1}};
const PlanLine line_along = {{0, 22}, {1, 0}};
const PlanLine line_through_corners = {{10, 20}, Vector2d (4, 3).normalized()};

/** \brief Areas of cells, ascending, rounded to 1e-6 m^2. */
std::vector<double>
areasOfCells (const std::vector<PlanCell>& cells)
{
  std::vector<double> areas;
  for (const PlanCell& cell : cells)
    areas.push_back (1e-6 * std::round (1e6 * areaOf (cell.corners)));
  std::sort (areas.begin(), areas.end());
  return areas;
}

/** \brief Number of sides of all cells that lie on a line, by its index or no_line. */
std::size_t
sidesOnLine (std::size_t line, const std::vector<PlanCell>& cells)
{
  std::size_t number = 0;
  for (const PlanCell& cell : cells)
    number += static_cast<std::size_t> (
        std::count (cell.lines.begin(), cell.lines.end(), line));
  return number;
}

} // namespace

TEST (PlanCells, AreTheWholePlanWithoutALineAcrossIt)
{
  const PlanLine beside = {{9, 0}, {0, 1}};
  const PlanLine at_the_rim = {{10, 0}, {0, 1}};
  const std::vector<PlanCell> cells = cellsOf (rim_of_plan, {beside, at_the_rim});
  EXPECT_EQ (areasOfCells (cells), std::vector<double>{12.0});
  EXPECT_EQ (sidesOnLine (no_line, cells), 4u);
}

TEST (PlanCells, AreFourOfTwoLinesThatCross)
{
  const std::vector<PlanCell> cells = cellsOf (rim_of_plan, {line_across, line_along});
  EXPECT_EQ (areasOfCells (cells), (std::vector<double>{1.0, 2.0, 3.0, 6.0}));
  EXPECT_EQ (sidesOnLine (0, cells), 4u);
  EXPECT_EQ (sidesOnLine (1, cells), 4u);
  EXPECT_EQ (sidesOnLine (no_line, cells), 8u);
}

TEST (PlanCells, AreTwoTrianglesWhereALineGoesThroughTwoCorners)
{
  const std::vector<PlanCell> cells = cellsOf (rim_of_plan, {line_through_corners});
  EXPECT_EQ (areasOfCells (cells), (std::vector<double>{6.0, 6.0}));
  for (const PlanCell& cell : cells) {
    EXPECT_EQ (cell.corners.size(), 3u);
    EXPECT_EQ (sidesOnLine (0, {cell}), 1u);
  }
}

TEST (CommonSides, AreBetweenCellsThatTouchAlongALine)
{
  // Four cells: each touches two others along a line.
  const std::vector<PlanCell> cells = cellsOf (rim_of_plan, {line_across, line_along});
  const std::vector<CommonSide> sides = commonSides (cells);
  ASSERT_EQ (sides.size(), 4u) << "sides at the rim belong to one cell";
  for (const CommonSide& side : sides) {
    EXPECT_NE (side.first, side.second);
    const PlanCell& cell = cells[side.first];
    EXPECT_NE (cell.lines[side.side], no_line);
    // Both ends of the side are corners of the other cell, too.
    for (const std::size_t end : {side.side, (side.side + 1) % cell.corners.size()})
      EXPECT_TRUE (std::any_of (cells[side.second].corners.begin(),
                                cells[side.second].corners.end(),
                                [&] (const Vector2d& corner) {
                                  return corner.isApprox (cell.corners[end]);
                                }));
  }
}

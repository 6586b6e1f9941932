// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_walls.h"

#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief A line that bounds cells (\ref PlanCell). */
struct CellLine {
  PlanLine line;
  /** \brief Intervals of the line on which walls are; empty for a line across a free
   * end. */
  Intervals walls = {};
  /** \brief Whether there are also walls whose front is behind the line. */
  bool faces_both_ways = false;
};

/** \brief Returns the lines that divide a plan: lines of walls, then lines across free
 * ends, which are the outermost ends of walls that meet no other wall. Lines across
 * free ends are left out if there would be more than max_walls (constants.h) lines. */
std::vector<CellLine>
cellLinesOf (const std::vector<WallFace>& faces, const std::vector<WallSpan>& spans);

} // namespace pcl_ops::internal::buildings

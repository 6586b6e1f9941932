// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Evidence for and against a cell being in a room. */
struct CellEvidence {
  /** \brief Area of the cell that floors, ceilings or roofs cover, and the rest [m^2].
   */
  double covered = 0.0;
  double uncovered = 0.0;
  /** \brief Length of the border that counts against the cell being in a room, whether
   * the cells beside it are in rooms or not [m]: that of the sides on the rim of the
   * plan, around all cells. For a cell within a wall it is the length of all sides. */
  double border_without_wall = 0.0;
};

/** \brief Two cells with a common side, by their indices in the list of cells. */
struct CellBorder {
  std::size_t first, second;
  /** \brief Length of the parts of the common side that have no wall [m]. */
  double open_length;
};

/** \brief Returns for each cell 1 if it is in a room, else 0. A minimum graph cut, as
 * in Ochmann et al. 2016 but with no labels for walls, minimizes the cost [m^2]
 *
 *     covered area outside of rooms + uncovered area inside of rooms
 *     + max_unseen * length of borders of rooms without a wall,
 *
 * where max_unseen [m] is that of constants.h. So a room extends over unseen floor up
 * to a wall. It can end at a wall even if some floor was seen beyond the wall. */
std::vector<char>
cellsInside (const std::vector<CellEvidence>& cells,
             const std::vector<CellBorder>& borders);

} // namespace pcl_ops::internal::buildings

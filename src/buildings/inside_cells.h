// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief What speaks for a cell to be in a room, and against it. */
struct CellEvidence {
  /** \brief Of its area, what is under ceilings or over floors, and the rest [m^2]. */
  double covered = 0.0;
  double uncovered = 0.0;
  /** \brief Length of its border to outside of all cells [m]. */
  double rim = 0.0;
};

/** \brief Two cells side by side. */
struct CellBorder {
  std::size_t first, second;
  /** \brief Length of their border without a wall [m]. */
  double open;
};

/** \brief Which cells are in rooms: for each 1 if it is, else 0. A minimum graph cut,
 * after Ochmann et al. 2016 without their walls, of the cost
 *   covered area outside + uncovered area inside
 *     + max_unseen [m] of constants.h * length of the border of rooms without a wall.
 * So a room goes on to a wall over a floor that was not seen, and ends at a wall though
 * a floor was seen beyond it. */
std::vector<char>
cellsInside (const std::vector<CellEvidence>& cells,
             const std::vector<CellBorder>& borders);

} // namespace pcl_ops::internal::buildings

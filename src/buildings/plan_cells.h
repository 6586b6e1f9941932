// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wall_faces.h"
#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief In PlanCell::lines: the side is on the rim of the plan, and on no line. */
constexpr std::size_t no_line = static_cast<std::size_t> (-1);

/** \brief A convex cell of a plan, bounded by lines and by the rim of the plan. */
struct PlanCell {
  /** \brief Counter-clockwise; the first corner is not repeated. */
  PlanarPoints corners;
  /** \brief For each side, from a corner to the next: the index of its line in the list
   * of lines, or no_line at the rim. */
  std::vector<std::size_t> lines;
};

/** \brief Divides a plan into cells by all lines. Each line is extended to the rim of
 * the plan.
 * \param[in] rim convex and counter-clockwise; the first corner is not repeated */
std::vector<PlanCell>
cellsOf (const PlanarPoints& rim, const std::vector<PlanLine>& lines);

/** \brief Two cells with a common side. */
struct CommonSide {
  /** \brief Indices of the two cells in the list of cells. */
  std::size_t first, second;
  /** \brief Index of the side in the first cell: the side runs from the corner of this
   * index to the next corner. */
  std::size_t side;
};

/** \brief Returns each side that two cells share, once. */
std::vector<CommonSide>
commonSides (const std::vector<PlanCell>& cells);

} // namespace pcl_ops::internal::buildings

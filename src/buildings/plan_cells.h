// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wall_faces.h"
#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief A convex part of a plan between lines. */
struct PlanCell {
  /** \brief Counter-clockwise. */
  PlanarPoints corners;
  /** \brief Of the side from each corner to the next: its line, a position in the list
   * of them, or no_line at the rim. */
  std::vector<std::size_t> lines;
};

constexpr std::size_t no_line = static_cast<std::size_t> (-1);

/** \brief Cuts a box by all lines, each from rim to rim. */
std::vector<PlanCell>
cellsOf (const Eigen::AlignedBox2d& box, const std::vector<PlanLine>& lines);

/** \brief Two cells with a common side. */
struct CommonSide {
  /** \brief Positions in the list of cells; the first has the side as its own. */
  std::size_t first, second;
  /** \brief Of the first: from this corner to the next. */
  std::size_t side;
};

std::vector<CommonSide>
commonSides (const std::vector<PlanCell>& cells);

} // namespace pcl_ops::internal::buildings

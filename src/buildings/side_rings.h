// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief A side of a cell of a plan, from one corner to the next [m]. */
struct PlanSide {
  Eigen::Vector2d from, to;
  /** \brief Index of its line in the list of lines; no_line (plan_cells.h) at the rim
   * of the plan. */
  std::size_t line;

  double
  length () const
  {
    return (to - from).norm();
  }
};

/** \brief Joins sides to rings: each side of a ring begins where the side before it
 * ends. Ends up to about 0.1 mm apart are one corner. Corners at which a ring does not
 * turn are left out, then rings with fewer than 3 corners. */
PlanarRings
ringsOf (const std::vector<PlanSide>& sides);

} // namespace pcl_ops::internal::buildings

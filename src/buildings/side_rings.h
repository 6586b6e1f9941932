// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief A side of a cell, with the index of its line; no_line at the rim. */
struct PlanSide {
  Eigen::Vector2d from, to;
  std::size_t line;

  double
  length () const
  {
    return (to - from).norm();
  }
};

/** \brief Joins sides end to end to rings; ends up to 0.1 mm apart are one corner.
 * Corners at which a ring does not turn are left out, then rings with fewer than 3
 * corners. */
PlanarRings
ringsOf (const std::vector<PlanSide>& sides);

} // namespace pcl_ops::internal::buildings

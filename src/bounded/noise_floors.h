// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cell_grid.h>

#include <algorithm>

namespace pcl_ops {

/** \brief No noise is measured more finely than this [m]. */
inline double
smallestNoise (const CellGrid& grid)
{
  constexpr double share_of_a_cell = 0.06;
  return share_of_a_cell * grid.cell_size;
}

/** \brief theta_h, or two cells where it is 0 [m]. */
inline double
distanceLimit (const CellGrid& grid, double distance_threshold)
{
  constexpr double cells = 2.0;
  return distance_threshold > 0.0 ? distance_threshold : cells * grid.cell_size;
}

/** \brief Distances below this always count as on the plane [m]. */
inline double
smallestBand (const CellGrid& grid, double limit)
{
  constexpr double share_of_a_cell = 0.2;
  return std::min (limit, share_of_a_cell * grid.cell_size);
}

} // namespace pcl_ops

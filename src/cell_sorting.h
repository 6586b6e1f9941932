// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/points.h>

#include <cstdint>
#include <vector>

namespace pcl_ops {

/** \brief Number of points in each cell. */
inline std::vector<std::uint32_t>
countPerCell (const std::vector<std::uint32_t>& cell_of_point, std::size_t cells)
{
  std::vector<std::uint32_t> count (cells, 0);
  for (const std::uint32_t cell : cell_of_point)
    ++count[cell];
  return count;
}

/** \brief Puts points cell after cell, those of a cell in their own order (counting
 * sort).
 * \param[in] cell_of_point the cell of each point
 * \param[in] cell_begin where each cell's first point goes
 * \param[in] visit called with each point and where it goes */
template <typename Visit>
Coordinates
sortByCell (const Coordinates& points,
            const std::vector<std::uint32_t>& cell_of_point,
            std::vector<std::uint32_t> cell_begin,
            Visit&& visit)
{
  Coordinates sorted;
  sorted.resize (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t place = cell_begin[cell_of_point[i]]++;
    sorted.x[place] = points.x[i];
    sorted.y[place] = points.y[i];
    sorted.z[place] = points.z[i];
    visit (i, place);
  }
  return sorted;
}

} // namespace pcl_ops

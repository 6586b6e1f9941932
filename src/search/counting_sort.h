// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
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

/** \brief Calls visit (point, place) with where each point goes when points are put
 * cell after cell, those of a cell in their own order (counting sort). \param[in]
 * cell_of_point the cell of each point \param[in] cell_begin where each cell's first
 * point goes */
template <typename Visit>
void
forPlacesByCell (const std::vector<std::uint32_t>& cell_of_point,
                 std::vector<std::uint32_t> cell_begin,
                 Visit&& visit)
{
  for (std::size_t i = 0; i < cell_of_point.size(); ++i)
    visit (i, cell_begin[cell_of_point[i]]++);
}

} // namespace pcl_ops

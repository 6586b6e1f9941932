// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cell_planes.h>
#include <pcl_ops/parallel.h>

namespace pcl_ops {

/** \brief Calls visit (plane, neighbour) for each neighbour of a cell that is on a
 * plane, and for the cell itself if it is. */
template <typename Visit>
void
forNeighboursOnPlanes (const CellGrid& grid,
                       const Labels& plane_of_cell,
                       std::size_t cell,
                       Visit&& visit)
{
  for (const std::uint32_t neighbour : grid.neighbours[cell])
    if (const std::int32_t plane = plane_of_cell[neighbour]; plane != no_plane)
      visit (static_cast<std::size_t> (plane), std::size_t (neighbour));
}

/** \brief Cells that one thread looks at in turn. */
constexpr std::size_t cells_per_piece = 1024;

/** \brief Calls visit (cell) for every cell, some at the same time. */
template <typename Visit>
void
forCells (const CellGrid& grid, unsigned threads, Visit&& visit)
{
  parallelFor (
      threads, grid.size(), cells_per_piece, [&] (std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          visit (i);
      });
}

/** \brief A cell and all that are connected to it.
 * \param[in] take (cell): whether the cell belongs to it; asked again of a cell that
 * was taken, it says no */
template <typename Take>
Positions
connectedCells (const CellGrid& grid, std::uint32_t start, Take&& take)
{
  Positions connected;
  if (!take (start))
    return connected;
  connected.push_back (start);
  for (std::size_t i = 0; i < connected.size(); ++i)
    for (const std::uint32_t neighbour : grid.neighbours[connected[i]])
      if (take (neighbour))
        connected.push_back (neighbour);
  return connected;
}

/** \brief Fits each plane to its cells. */
void
refitPlanes (const CellGrid& grid, CellPlanes& planes);

} // namespace pcl_ops

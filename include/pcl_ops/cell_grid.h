// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane.h>
#include <pcl_ops/points.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl_ops {

/** \brief Integer coordinates of a cell of a grid. */
struct CellKey {
  std::int32_t x = 0, y = 0, z = 0;
};

/** \brief Positions of a cell's 26 neighbours and, in the middle, of the cell itself;
 * -1 where a neighbour holds no point. */
using Neighbourhood = std::array<std::int32_t, 27>;

/** \brief The occupied cells of a uniform grid with the moments of the points in each.
 */
struct CellGrid {
  /** \brief Edge of a cell [m]. */
  double cell_size = 0.0;
  /** \brief Coordinates of each occupied cell, in an order that depends on them alone:
   * neighbours in space are near in memory. */
  std::vector<CellKey> keys;
  /** \brief Moments of each cell's points about the zero of their frame. */
  std::vector<Moments> moments;
  std::vector<Neighbourhood> neighbours;

  std::size_t
  size () const
  {
    return keys.size();
  }
};

/** \brief A grid with the cell of each point. */
struct GriddedPoints {
  CellGrid grid;
  std::vector<std::uint32_t> cell_of_point;
};

/** \brief Cell edge at which the points fill about \p wanted_cells cells.
 *
 * Counted on a few thousand points in cells so large that they show all occupied ones,
 * and carried over to small cells as for surfaces, whose occupied cells grow with the
 * inverse square of the edge.
 * \return 0 for fewer than two different points */
double
cellSizeFor (const Coordinates& positions, double wanted_cells);

/** \brief Sorts points into cells and adds up their moments in one pass.
 * \param[in] positions finite points; coordinates beyond 2^20 cells from zero share the
 * outermost cells
 * \param[in] cell_size edge of a cell, above 0
 * \param[in] threads number of threads; 0: all. The result does not depend on it */
GriddedPoints
gridPoints (const Coordinates& positions, double cell_size, unsigned threads);

/** \brief A grid of twice the cell size whose cells hold 2 x 2 x 2 cells each. */
struct CoarserGrid {
  CellGrid grid;
  /** \brief For each finer cell the coarser one that holds it. */
  std::vector<std::uint32_t> cell_of_finer;
};

CoarserGrid
coarsen (const CellGrid& finer);

} // namespace pcl_ops

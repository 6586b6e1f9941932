// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane.h>
#include <pcl_ops/points.h>

#include <cstdint>
#include <vector>

namespace pcl_ops {

/** \brief Integer coordinates of a cell of a grid. */
struct CellKey {
  std::int32_t x = 0, y = 0, z = 0;
};

/** \brief Positions of cells, one after the other. */
struct CellRange {
  const std::uint32_t* first;
  const std::uint32_t* last;

  const std::uint32_t*
  begin () const
  {
    return first;
  }

  const std::uint32_t*
  end () const
  {
    return last;
  }
};

/** \brief For each cell the occupied ones among its 26 neighbours and, in the middle,
 * itself: most are empty where points are on surfaces. */
class CellNeighbours {
public:
  CellRange
  operator[] (std::size_t cell) const
  {
    return {neighbours_.data() + begin_[cell], neighbours_.data() + begin_[cell + 1]};
  }

  /** \brief Number of cells. */
  std::size_t
  size () const
  {
    return begin_.size() - 1;
  }

  void
  reserve (std::size_t cells)
  {
    constexpr std::size_t usual_neighbours = 12;
    begin_.reserve (cells + 1);
    neighbours_.reserve (usual_neighbours * cells);
  }

  /** \brief Appends the next cell with its \p number neighbours. */
  void
  add (const std::uint32_t* neighbours, std::size_t number)
  {
    neighbours_.insert (neighbours_.end(), neighbours, neighbours + number);
    begin_.push_back (static_cast<std::uint32_t> (neighbours_.size()));
  }

  /** \brief Appends the cells of another part of the grid. */
  void
  append (const CellNeighbours& other)
  {
    const auto before = static_cast<std::uint32_t> (neighbours_.size());
    neighbours_.insert (
        neighbours_.end(), other.neighbours_.begin(), other.neighbours_.end());
    for (std::size_t i = 1; i < other.begin_.size(); ++i)
      begin_.push_back (before + other.begin_[i]);
  }

private:
  std::vector<std::uint32_t> neighbours_;
  std::vector<std::uint32_t> begin_{0};
};

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
  CellNeighbours neighbours;

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
coarsen (const CellGrid& finer, unsigned threads);

} // namespace pcl_ops

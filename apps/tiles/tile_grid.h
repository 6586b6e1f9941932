// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace pcl_ops::apps {

/** \brief Number of a cell along x, y and z. Cell 0 begins at zero of the frame (the
 * coordinate system) that all inputs share. */
using CellKey = std::array<std::int64_t, 3>;

/** \brief Number of a tile along x and y: its first cell is the number times \ref
 * TileGrid::cells_of_tile. */
using TileKey = std::array<std::int64_t, 2>;

/** \brief A lattice of cubic cells from zero of the inputs' frame, and square tiles of
 * whole columns of cells. Intervals are half-open: a point is in one cell and one tile.
 * Around each tile is a halo: a border of cells of other tiles whose points the tile
 * sees, too. [m] stands for the unit of the inputs. */
struct TileGrid {
  /** \brief Width of the voxels of the coarsest resolution of normals [cells]. */
  static constexpr std::int64_t cells_of_coarsest = 4;
  /** \brief Width of the halo [cells]: three voxels of the coarsest resolution. Pieces
   * of planes in two tiles are joined by the cells that both tiles see (joinPlanes). */
  static constexpr std::int64_t halo = 12;
  /** \brief Largest distance from zero along each axis [cells]: numbers of cells fit
   * into 32 bits (BorderVoxel::cell). */
  static constexpr std::int64_t max_cells = 1'000'000'000;

  /** \brief Edge of a cell [m]. */
  double edge = 0.0;
  /** \brief Cells along an edge of a tile: a multiple of \ref cells_of_coarsest and at
   * least \ref halo. */
  std::int64_t cells_of_tile = 0;
  /** \brief A cell near the points, for the frames of tiles (\ref frameOf). Each number
   * is a multiple of \ref cells_of_coarsest. */
  CellKey cell_near_points{};

  /** \brief Edge of a tile [m]. */
  double
  edgeOfTile () const
  {
    return edge * cells_of_tile;
  }

  /** \brief How far from zero cells can be counted [m]. */
  double
  reach () const
  {
    return max_cells * edge;
  }

  /** \brief Whether a point is finite and within \ref reach along each axis. */
  bool
  reaches (const Eigen::Vector3d& point) const
  {
    return (point.array().abs() < reach()).all();
  }

  /** \param[in] point within \ref reach, else its numbers may overflow */
  CellKey
  cellOf (const Eigen::Vector3d& point) const
  {
    const auto along = [this] (double coordinate) {
      return static_cast<std::int64_t> (std::floor (coordinate / edge));
    };
    return {along (point.x()), along (point.y()), along (point.z())};
  }

  TileKey
  tileOf (const CellKey& cell) const
  {
    const auto along = [this] (std::int64_t number) {
      // Integer division rounds towards zero; tiles are counted by rounding down.
      const std::int64_t tile = number / cells_of_tile;
      return tile * cells_of_tile > number ? tile - 1 : tile;
    };
    return {along (cell[0]), along (cell[1])};
  }

  /** \brief Whether a cell is in a tile and in the halo of no other tile. */
  bool
  isSeenOnlyBy (const TileKey& tile, const CellKey& cell) const
  {
    const auto along = [&] (std::size_t axis) {
      const std::int64_t from_border = cell[axis] - tile[axis] * cells_of_tile;
      return from_border >= halo && from_border < cells_of_tile - halo;
    };
    return along (0) && along (1);
  }

  /** \brief Returns the cell whose corner is the zero of a tile's frame: \ref
   * cell_near_points, clamped to the tile along x and y. Each number is a multiple of
   * \ref cells_of_coarsest. */
  CellKey
  frameOf (const TileKey& tile) const
  {
    const auto along = [&] (std::size_t axis) {
      const std::int64_t first = tile[axis] * cells_of_tile;
      return std::clamp (cell_near_points[axis], first, first + cells_of_tile);
    };
    return {along (0), along (1), cell_near_points[2]};
  }

  /** \brief Returns the corner of a cell with the smallest coordinates [m]. */
  Eigen::Vector3d
  cornerOf (const CellKey& cell) const
  {
    return edge * Eigen::Vector3d (cell[0], cell[1], cell[2]);
  }

  /** \brief Calls visit (tile) for each other tile that has this cell in its halo. */
  template <typename Visit>
  void
  forTilesAround (const CellKey& cell, Visit&& visit) const
  {
    const TileKey own = tileOf (cell);
    const auto sees = [&] (std::size_t axis, std::int64_t step) {
      const std::int64_t from_border = cell[axis] - own[axis] * cells_of_tile;
      return step == 0 ||
             (step < 0 ? from_border < halo : from_border >= cells_of_tile - halo);
    };
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        if ((dx != 0 || dy != 0) && sees (0, dx) && sees (1, dy))
          visit (TileKey{own[0] + dx, own[1] + dy});
  }
};

} // namespace pcl_ops::apps

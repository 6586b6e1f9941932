// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace pcl_ops::apps {

/** \brief Numbers of a cell along x, y and z. Cell (0, 0, 0) begins at zero of the
 * frame (the coordinate system) that all inputs share. */
using CellKey = std::array<std::int64_t, 3>;

/** \brief Numbers of a tile along x and y. The number of its first cell along an axis
 * is this number times \ref TileGrid::cells_of_tile. */
using TileKey = std::array<std::int64_t, 2>;

/** \brief A lattice of cubic cells that begins at zero of the inputs' frame, and square
 * tiles of whole columns of cells along z. A point on a border is in the cell and the
 * tile with the larger numbers. Around each tile is a halo: a border of cells of other
 * tiles whose points the tile sees, too. [m] stands for the unit of the inputs. */
struct TileGrid {
  /** \brief Width of the largest voxels that normals are computed in [cells]. */
  static constexpr std::int64_t cells_of_coarsest = 4;
  /** \brief Width of the halo [cells]: three of these largest voxels. Pieces of planes
   * in two tiles are joined by the cells that both tiles see (joinPlanes). */
  static constexpr std::int64_t halo = 12;
  /** \brief Largest distance of a point from zero along each axis, and largest width of
   * a tile [cells]: numbers of cells fit into 32 bits (BorderVoxel::cell). */
  static constexpr std::int64_t max_cells = 1'000'000'000;

  /** \brief Edge of a cell [m]. */
  double edge = 0.0;
  /** \brief Number of cells along an edge of a tile: a multiple of \ref
   * cells_of_coarsest and at least \ref halo. */
  std::int64_t cells_of_tile = 0;
  /** \brief A cell near the points, from which frames of tiles follow (\ref frameOf).
   * Each number is a multiple of \ref cells_of_coarsest. */
  CellKey cell_near_points{};

  /** \brief Edge of a tile [m]. */
  double
  edgeOfTile () const
  {
    return edge * cells_of_tile;
  }

  /** \brief Distance from zero along an axis at which the numbers of cells end [m]. */
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

  /** \param[in] point [m], within \ref reach: else numbers may overflow */
  CellKey
  cellOf (const Eigen::Vector3d& point) const
  {
    const auto cell_number = [this] (double coordinate) {
      return static_cast<std::int64_t> (std::floor (coordinate / edge));
    };
    return {cell_number (point.x()), cell_number (point.y()), cell_number (point.z())};
  }

  TileKey
  tileOf (const CellKey& cell) const
  {
    const auto tile_number = [this] (std::int64_t number_of_cell) {
      // Integer division rounds towards zero, but the number has to be rounded down.
      const std::int64_t tile = number_of_cell / cells_of_tile;
      return tile * cells_of_tile > number_of_cell ? tile - 1 : tile;
    };
    return {tile_number (cell[0]), tile_number (cell[1])};
  }

  /** \brief Whether a cell is in a tile and in the halo of no other tile. */
  bool
  isSeenOnlyBy (const TileKey& tile, const CellKey& cell) const
  {
    const auto is_beyond_halos = [&] (std::size_t axis) {
      const std::int64_t from_border = cell[axis] - tile[axis] * cells_of_tile;
      return from_border >= halo && from_border < cells_of_tile - halo;
    };
    return is_beyond_halos (0) && is_beyond_halos (1);
  }

  /** \brief Returns the cell whose corner is the zero of a tile's frame: \ref
   * cell_near_points, clamped to the tile along x and y. Each number is a multiple of
   * \ref cells_of_coarsest. */
  CellKey
  frameOf (const TileKey& tile) const
  {
    const auto clamped_number = [&] (std::size_t axis) {
      const std::int64_t first = tile[axis] * cells_of_tile;
      return std::clamp (cell_near_points[axis], first, first + cells_of_tile);
    };
    return {clamped_number (0), clamped_number (1), cell_near_points[2]};
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
    // Whether the next tile along an axis in the direction of a step, -1 or 1, has the
    // cell in its halo; true for step 0.
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

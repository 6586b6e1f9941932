// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "exact_moments.h"
#include "outline_edges.h"
#include "plan.h"
#include <pcl_ops/detection_report.h>

#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace pcl_ops::apps {

/** \brief The part of a plane that a tile sees. */
struct TilePiece {
  /** \brief Moments of the tile's own points on the piece, in the frame of the inputs.
   */
  ExactMoments own_moments;
  /** \brief Moments of the points in the tile and its halo, in the same frame. */
  Moments seen_moments;
  /** \brief Unit normal. To a viewer on the side that it points to, the piece lies to
   * the left of each edge. */
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  /** \brief The tile's share of the outline (\ref outlineEdges). */
  std::vector<OutlineEdge> edges;
  /** \brief Positions in Plan::inputs of the inputs with own points on the piece. */
  std::vector<std::uint32_t> inputs;
};

/** \brief A cell of \ref TileGrid that another tile sees, too, and a piece that has
 * points in it. */
struct BorderVoxel {
  /** \brief The \ref CellKey of the cell in half the memory: numbers are up to \ref
   * TileGrid::max_cells. */
  std::array<std::int32_t, 3> cell{};
  /** \brief Position of the piece in TilePlanes::pieces. */
  std::uint32_t piece = 0;

  friend bool
  operator<(const BorderVoxel& a, const BorderVoxel& b)
  {
    return std::tie (a.cell, a.piece) < std::tie (b.cell, b.piece);
  }
};

/** \brief The pieces of planes in a tile; pieces with points in its halo alone are left
 * out. */
struct TilePlanes {
  /** \brief By falling number of points in the tile and its halo. */
  std::vector<TilePiece> pieces;
  /** \brief In ascending order, without duplicates. */
  std::vector<BorderVoxel> border_voxels;
};

/** \brief Writes the file in one step. \throws WorkError if it cannot be written */
void
saveTilePlanes (const std::string& file, const TilePlanes& planes);

/** \brief Reads a file of \ref saveTilePlanes. \throws WorkError if it cannot be read
 */
TilePlanes
loadTilePlanes (const std::string& file);

/** \brief The number of a tile's own points in one input. */
struct OwnPoints {
  /** \brief Position in Plan::inputs. */
  std::uint32_t input;
  std::uint64_t count;
};

/** \brief The points that a tile sees. */
struct TilePoints {
  TileKey tile;
  /** \brief In the frame of the tile: its own points, input by input, then those of the
   * halo. */
  std::vector<Eigen::Vector3f> points;
  /** \brief The inputs that have own points, in the order of their points. */
  std::vector<OwnPoints> own_of_inputs;
};

/** \brief The result of \ref detectInTile. */
struct TileDetection {
  TilePlanes planes;
  /** \brief For each own point the number of its piece: the position in
   * TilePlanes::pieces plus 1, or 0 for no piece. */
  std::vector<std::uint32_t> piece_numbers;
};

/** \brief Finds planes with the default of OPS; if Plan::is_on_voxels is set, on
 * voxels, which are the cells of the grid.
 * \param[in] noise of the survey; nothing for a single tile or on voxels
 * \throws std::bad_alloc if the memory, or the range of pcl::index_t, is too small for
 * the points */
TileDetection
detectInTile (const Plan& plan,
              const std::optional<CloudNoise>& noise,
              const TilePoints& points);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "cell_file.h"
#include "exact_moments.h"
#include "plane_outline.h"
#include "tile_grid.h"

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace pcl_ops::apps {

/** \brief What a tile has of a plane. */
struct Piece {
  /** \brief Of the tile's own points on it, in the frame of the inputs. */
  ExactMoments own;
  /** \brief Of those of the halo, too. */
  Moments all;
  /** \brief Towards where the plane is seen from, whose edges go round it to the left.
   */
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  std::vector<OutlineEdge> edges;
  /** \brief The inputs that its own points are from, by their position in the plan. */
  std::vector<std::uint32_t> inputs;
};

/** \brief A cell near the border of a tile with points on a piece. */
struct Claim {
  std::array<std::int32_t, 3> cell{};
  std::uint32_t piece = 0;

  friend bool
  operator<(const Claim& a, const Claim& b)
  {
    return std::tie (a.cell[0], a.cell[1], a.cell[2], a.piece) <
           std::tie (b.cell[0], b.cell[1], b.cell[2], b.piece);
  }
  friend bool
  operator== (const Claim& a, const Claim& b)
  {
    return a.cell == b.cell && a.piece == b.piece;
  }
};

/** \brief All planes of a tile that have points of its own. */
struct TilePlanes {
  /** \brief By falling size as seen in the tile and its halo. */
  std::vector<Piece> pieces;
  /** \brief Sorted, each once. */
  std::vector<Claim> claims;
};

/** \brief Writes it in one step. \throws WorkError if it cannot be written */
void
saveTilePlanes (const std::string& file, const TilePlanes& planes);

/** \throws WorkError if it cannot be read */
TilePlanes
loadTilePlanes (const std::string& file);

/** \brief The labels of a tile's own points of one input: 0 or a piece's number from 1
 * on, in the order of the input. */
struct LabelsOfInput {
  std::uint32_t input = 0;
  std::vector<std::uint32_t> labels;
};

void
saveTileLabels (const std::string& file, const std::vector<LabelsOfInput>& labels);

/** \brief Reads the labels of one input in their order, some at a time. */
class LabelReader {
public:
  LabelReader (const std::string& file, std::uint32_t input);

  /** \throws WorkError if there is none left */
  std::uint32_t
  next ();

private:
  void
  refill ();

  std::string file_;
  std::uint64_t place_ = 0, left_ = 0;
  std::vector<std::uint32_t> some_;
  std::size_t used_ = 0;
};

/** \brief The points a tile looks at, in its frame: its own of each input, then its
 * halo.
 */
struct TilePoints {
  TileKey tile;
  /** \brief x, y, z of each. */
  std::vector<float> coordinates;
  /** \brief The inputs with points in the tile, and how many of the points are theirs.
   */
  std::vector<std::pair<std::uint32_t, std::uint64_t>> own_of_input;

  std::size_t
  own () const;

  std::size_t
  size () const
  {
    return coordinates.size() / 3;
  }
};

struct TileDetection {
  TilePlanes planes;
  std::vector<LabelsOfInput> labels;
};

/** \brief Finds planes with the library's recommended preset in voxels of the grid. */
TileDetection
detectInTile (const TileGrid& grid, const TilePoints& points);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "exact_moments.h"
#include "plan.h"
#include "plane_outline.h"
#include <pcl_ops/detection_report.h>

#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace pcl_ops::apps {

/** \brief What a tile has of a plane. */
struct Piece {
  /** \brief Of the tile's own points on it, in the frame of the inputs. */
  ExactMoments own;
  /** \brief Of those of the halo, too. */
  Moments all;
  /** \brief Towards where the plane is seen from; edges go round it to the left. */
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  std::vector<OutlineEdge> edges;
  /** \brief The inputs that its own points are from, by their position in the plan. */
  std::vector<std::uint32_t> inputs;
};

/** \brief A cell near the border of a tile with points on a piece. */
struct BorderVoxel {
  std::array<std::int32_t, 3> cell{};
  std::uint32_t piece = 0;

  friend bool
  operator<(const BorderVoxel& a, const BorderVoxel& b)
  {
    return std::tie (a.cell, a.piece) < std::tie (b.cell, b.piece);
  }
};

/** \brief All planes of a tile that have points of its own. */
struct TilePlanes {
  /** \brief By falling size as seen in the tile and its halo. */
  std::vector<Piece> pieces;
  /** \brief Sorted, each once. */
  std::vector<BorderVoxel> border_voxels;
};

/** \brief Writes it in one step. \throws WorkError if it cannot be written */
void
saveTilePlanes (const std::string& file, const TilePlanes& planes);

/** \throws WorkError if it cannot be read */
TilePlanes
loadTilePlanes (const std::string& file);

/** \brief What a tile looks at, in its frame: its own points by input, then the halo.
 */
struct TilePoints {
  TileKey tile;
  std::vector<Eigen::Vector3f> points;
  /** \brief The inputs with points in the tile, and how many of the points are theirs.
   */
  std::vector<std::pair<std::uint32_t, std::uint64_t>> own_of_input;
};

struct TileDetection {
  TilePlanes planes;
  /** \brief Of the tile's own points: 0, or a piece's number from 1 on. */
  std::vector<std::uint32_t> labels;
};

/** \brief Finds planes with the library's recommended preset, in voxels of the grid if
 * their size was given.
 * \param[in] noise of the survey, unless it is one tile */
TileDetection
detectInTile (const Plan& plan,
              const std::optional<CloudNoise>& noise,
              const TilePoints& points);

} // namespace pcl_ops::apps

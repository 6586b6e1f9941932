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

/** \brief The part of a plane that a tile sees. */
struct Piece {
  /** \brief Moments of the tile's own points on it, in the frame of the inputs. */
  ExactMoments own;
  /** \brief The same with the points of the halo. */
  Moments all;
  /** \brief Seen from the side it points to, the plane is to the left of its edges. */
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  std::vector<OutlineEdge> edges;
  /** \brief Positions in the plan of the inputs with own points on it. */
  std::vector<std::uint32_t> inputs;
};

/** \brief A cell with points on a piece that another tile sees, too. */
struct BorderVoxel {
  std::array<std::int32_t, 3> cell{};
  std::uint32_t piece = 0;

  friend bool
  operator<(const BorderVoxel& a, const BorderVoxel& b)
  {
    return std::tie (a.cell, a.piece) < std::tie (b.cell, b.piece);
  }
};

/** \brief The pieces of a tile that have own points. */
struct TilePlanes {
  /** \brief By falling number of points in the tile and its halo. */
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

/** \brief The points a tile sees, in its frame: its own by input, then the halo. */
struct TilePoints {
  TileKey tile;
  std::vector<Eigen::Vector3f> points;
  /** \brief The inputs with own points of the tile, and how many each has. */
  std::vector<std::pair<std::uint32_t, std::uint64_t>> own_of_input;
};

struct TileDetection {
  TilePlanes planes;
  /** \brief Per own point: 0 for no plane, else the position of its piece plus 1. */
  std::vector<std::uint32_t> labels;
};

/** \brief Finds planes with the library's recommended preset, in voxels of the grid if
 * their size was given.
 * \param[in] noise of the survey; nothing for a single tile or on voxels */
TileDetection
detectInTile (const Plan& plan,
              const std::optional<CloudNoise>& noise,
              const TilePoints& points);

} // namespace pcl_ops::apps

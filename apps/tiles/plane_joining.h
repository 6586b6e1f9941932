// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_planes.h"

#include <functional>

namespace pcl_ops::apps {

/** \brief A plane of the survey, joined from the pieces of one or more tiles. */
struct JoinedPlane {
  /** \brief Moments of all points on the plane, each once: of the own points of the
   * pieces. */
  ExactMoments moments;
  /** \brief Fit to \ref moments. If these points span no plane: fit to the points of
   * the first piece, with those in the halo of its tile. */
  PlaneFit fit;
  /** \brief Unit normal, that of the first piece: to a viewer on the side that it
   * points to, the plane lies to the left of each edge. */
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  /** \brief Edges of all pieces; between two tiles they come in opposite pairs. */
  std::vector<OutlineEdge> edges;
  /** \brief The tiles of the pieces, without duplicates. */
  std::vector<TileKey> tiles;
  /** \brief Positions in Plan::inputs of the inputs with points on the plane. */
  std::vector<std::uint32_t> inputs;
};

struct JoinedPlanes {
  /** \brief By falling number of points. */
  std::vector<JoinedPlane> planes;
  /** \brief For each tile, for each of its pieces: the position of the piece's plane in
   * \ref planes plus 1. */
  std::vector<std::vector<std::uint32_t>> numbers;
};

/** \brief Joins pieces of neighboring tiles that are on the same plane.
 *
 * A tile also sees the points of its halo. So two tiles may have pieces with points in
 * the same cells. Pairs of pieces with points in the same three cells or more are
 * tested, those with most such cells first. Each piece is in a group with the pieces
 * that it was joined with before. The groups of a pair are joined if \ref mergePlanes
 * merges their moments, by the noise instead of a threshold of distances.
 * \param[in] tiles in ascending order
 * \param[in] load returns the pieces of a tile; called several times for each, so that
 * the border voxels of two tiles at most are in memory */
JoinedPlanes
joinPlanes (const std::vector<TileKey>& tiles,
            const std::function<TilePlanes (const TileKey&)>& load);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_planes.h"

#include <functional>

namespace pcl_ops::apps {

struct JoinedPlane {
  ExactMoments moments;
  PlaneFit fit;
  /** \brief Seen from the side it points to, the plane is to the left of its edges. */
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  /** \brief Edges of all pieces; between two tiles they come in opposite pairs. */
  std::vector<OutlineEdge> edges;
  std::vector<TileKey> tiles;
  std::vector<std::uint32_t> inputs;
};

struct JoinedPlanes {
  /** \brief By falling number of points. */
  std::vector<JoinedPlane> planes;
  /** \brief For each tile, for each of its pieces, the number of its plane from 1 on.
   */
  std::vector<std::vector<std::uint32_t>> numbers;
};

/** \brief Joins pieces of neighboring tiles that are on the same plane.
 *
 * A tile also sees points of its halo. Each cell where pieces of two tiles both have
 * points is a vote for the pair. Pairs with three votes or more are examined, most
 * votes first: they are joined if \ref mergePlanes merges the moments of the groups
 * that either piece has been joined with before.
 * \param[in] tiles sorted
 * \param[in] load returns the pieces of a tile; called several times for each, so that
 * the border voxels of two tiles at most are in memory */
JoinedPlanes
joinPlanes (const std::vector<TileKey>& tiles,
            const std::function<TilePlanes (const TileKey&)>& load);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_planes.h"

#include <functional>

namespace pcl_ops::apps {

struct JoinedPlane {
  ExactMoments moments;
  PlaneFit fit;
  /** \brief Towards where \ref edges are seen from. */
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  /** \brief Of all its pieces, with opposite ones at their borders. */
  std::vector<OutlineEdge> edges;
  std::vector<TileKey> tiles;
  std::vector<std::uint32_t> inputs;
};

struct JoinedPlanes {
  /** \brief By falling size. */
  std::vector<JoinedPlane> planes;
  /** \brief For each tile, for each of its pieces, the number of its plane from 1 on.
   */
  std::vector<std::vector<std::uint32_t>> numbers;
};

/** \brief Makes one plane of pieces on both sides of a border.
 *
 * Tiles look at points beyond their borders. Where pieces of two tiles are on points of
 * the same cells there, each such cell is a vote for the pair; pairs with enough votes
 * are one plane if the library's merging says so of all that has been joined with
 * either before, pairs with most votes first.
 * \param[in] tiles sorted
 * \param[in] load the planes of a tile; asked several times, so that not all of them are
 * in memory */
JoinedPlanes
joinPlanes (const std::vector<TileKey>& tiles,
            const std::function<TilePlanes (const TileKey&)>& load);

} // namespace pcl_ops::apps

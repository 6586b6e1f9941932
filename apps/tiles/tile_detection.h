// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_grid.h"
#include "tile_planes.h"

#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

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

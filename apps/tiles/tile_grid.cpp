// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tile_grid.h"

#include <algorithm>

namespace pcl_ops::apps {

CellKey
TileGrid::frameOf (const TileKey& tile) const
{
  const auto along = [this] (std::int64_t place, std::int64_t number) {
    const std::int64_t first = number * cells_of_tile_;
    return std::clamp (place, first, first + cells_of_tile_);
  };
  return {along (place_[0], tile.x), along (place_[1], tile.y), place_[2]};
}

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cell_grid.h>
#include <pcl_ops/points.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace pcl_ops {

/** \brief Keys of some points along one axis: rounded down, shifted above zero. */
inline void
keysOf (const float* coordinates,
        std::size_t number,
        float cells_per_metre,
        std::int32_t* keys)
{
  constexpr std::int32_t key_range = 1 << 20;
  constexpr auto limit = static_cast<float> (key_range - 1);
  for (std::size_t i = 0; i < number; ++i) {
    const float scaled =
        std::min (std::max (coordinates[i] * cells_per_metre, -limit), limit);
    const auto truncated = static_cast<std::int32_t> (scaled);
    keys[i] = truncated - (scaled < static_cast<float> (truncated)) + key_range;
  }
}

/** \brief Calls visit (i, key) for the points of a range, whose keys it computes by the
 * batch. */
template <typename Visit>
void
forKeys (const Coordinates& positions,
         double cell_size,
         std::size_t begin,
         std::size_t end,
         Visit&& visit)
{
  constexpr std::size_t batch = 512;
  std::array<std::int32_t, batch> x, y, z;
  const auto cells_per_metre = static_cast<float> (1.0 / cell_size);
  for (std::size_t first = begin; first < end; first += batch) {
    const std::size_t number = std::min (batch, end - first);
    keysOf (positions.x.data() + first, number, cells_per_metre, x.data());
    keysOf (positions.y.data() + first, number, cells_per_metre, y.data());
    keysOf (positions.z.data() + first, number, cells_per_metre, z.data());
    for (std::size_t i = 0; i < number; ++i)
      visit (first + i, CellKey{x[i], y[i], z[i]});
  }
}

} // namespace pcl_ops

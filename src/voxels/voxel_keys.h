// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"
#include "voxels/voxel_grid.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace pcl_ops::internal {

/** \brief Keys of some points along one axis: rounded down, shifted above zero. */
inline void
keysOf (const float* coordinates,
        std::size_t number,
        float voxels_per_metre,
        std::int32_t* keys)
{
  constexpr std::int32_t key_range = 1 << 20;
  constexpr auto limit = static_cast<float> (key_range - 1);
  for (std::size_t i = 0; i < number; ++i) {
    // In this order NaN, of 0 in voxels too small for their inverse, becomes a limit.
    const float scaled =
        std::min (limit, std::max (-limit, coordinates[i] * voxels_per_metre));
    const auto truncated = static_cast<std::int32_t> (scaled);
    keys[i] = truncated - (scaled < static_cast<float> (truncated)) + key_range;
  }
}

/** \brief Calls visit (first, last, key) for runs of points of a range that have the
 * same key, in their order. Points that follow each other mostly share a voxel: where
 * they do not is found without a branch. */
template <typename Visit>
void
forRuns (const Coordinates& positions,
         double voxel_size,
         std::size_t begin,
         std::size_t end,
         Visit&& visit)
{
  constexpr std::size_t batch = 512;
  std::array<std::int32_t, batch> x, y, z;
  std::array<std::uint32_t, batch + 1> run_begin;
  const auto voxels_per_metre = static_cast<float> (1.0 / voxel_size);
  for (std::size_t first = begin; first < end; first += batch) {
    const std::size_t number = std::min (batch, end - first);
    keysOf (positions.x.data() + first, number, voxels_per_metre, x.data());
    keysOf (positions.y.data() + first, number, voxels_per_metre, y.data());
    keysOf (positions.z.data() + first, number, voxels_per_metre, z.data());
    std::size_t runs = 0;
    run_begin[0] = 0;
    for (std::size_t i = 1; i < number; ++i) {
      const std::int32_t change =
          (x[i] ^ x[i - 1]) | (y[i] ^ y[i - 1]) | (z[i] ^ z[i - 1]);
      run_begin[runs + 1] = static_cast<std::uint32_t> (i);
      runs += change != 0;
    }
    run_begin[++runs] = static_cast<std::uint32_t> (number);
    for (std::size_t r = 0; r < runs; ++r) {
      const std::size_t i = run_begin[r];
      visit (first + i, first + run_begin[r + 1], VoxelKey{x[i], y[i], z[i]});
    }
  }
}

} // namespace pcl_ops::internal

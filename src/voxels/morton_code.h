// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pcl_ops::internal {

/** \brief Integer coordinates of a voxel of a grid. */
struct VoxelKey {
  std::int32_t x = 0, y = 0, z = 0;
};

/** \brief The bits of a voxel's coordinates, z, y, x, from the highest on: sorted by
 * it, voxels that share a larger one follow each other. Divided by 8 it is the code of
 * the voxel of twice the edge. */
using MortonCode = std::uint64_t;

constexpr std::int32_t key_bits = 20;

/** \brief Coordinates along one axis: rounded down, in voxels, within 2^20 of zero. */
inline void
keysOf (const float* coordinates,
        std::size_t number,
        float voxels_per_metre,
        std::int32_t* keys)
{
  constexpr auto limit = static_cast<float> ((1 << key_bits) - 1);
  for (std::size_t i = 0; i < number; ++i) {
    // In this order NaN, of 0 in voxels too small for their inverse, becomes a limit.
    const float scaled =
        std::min (limit, std::max (-limit, coordinates[i] * voxels_per_metre));
    const auto truncated = static_cast<std::int32_t> (scaled);
    keys[i] = truncated - (scaled < static_cast<float> (truncated));
  }
}

/** \brief Two zeros after each of the lowest 21 bits. */
inline MortonCode
spreadBits (std::uint32_t bits)
{
  MortonCode code = bits;
  code = (code | code << 32) & 0x001f00000000ffff;
  code = (code | code << 16) & 0x001f0000ff0000ff;
  code = (code | code << 8) & 0x100f00f00f00f00f;
  code = (code | code << 4) & 0x10c30c30c30c30c3;
  return (code | code << 2) & 0x1249249249249249;
}

/** \brief Every third bit, the lowest first: undoes \ref spreadBits. */
inline std::uint32_t
gatherBits (MortonCode code)
{
  code &= 0x1249249249249249;
  code = (code | code >> 2) & 0x10c30c30c30c30c3;
  code = (code | code >> 4) & 0x100f00f00f00f00f;
  code = (code | code >> 8) & 0x001f0000ff0000ff;
  code = (code | code >> 16) & 0x001f00000000ffff;
  return static_cast<std::uint32_t> ((code | code >> 32) & 0x1fffff);
}

/** \brief Of coordinates at least 0 and below 2^21. */
inline MortonCode
mortonCode (std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
  return spreadBits (x) | spreadBits (y) << 1 | spreadBits (z) << 2;
}

/** \brief The coordinates that a code is made of. */
inline VoxelKey
keyOf (MortonCode code)
{
  return {static_cast<std::int32_t> (gatherBits (code)),
          static_cast<std::int32_t> (gatherBits (code >> 1)),
          static_cast<std::int32_t> (gatherBits (code >> 2))};
}

} // namespace pcl_ops::internal

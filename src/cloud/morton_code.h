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

/** \brief The bits of a voxel's coordinates, z, y, x, from the highest on, 60 in all:
 * sorted by it, voxels that share a larger one follow each other. Divided by 8 it is
 * the code of the voxel of twice the edge. */
using MortonCode = std::uint64_t;

/** \brief Largest distance of a key from zero [voxels]. */
constexpr std::int32_t key_limit = 1 << 18;

/** \brief What makes a key a number above zero: a multiple of 16, so that voxels
 * of up to 16 times the edge begin at zero, too. Above, its bits alternate: keys near
 * zero share the upper ones, which then need no sorting. */
constexpr std::int32_t key_offset = 0x55550;

/** \brief Coordinates along one axis: rounded down, in voxels; those beyond \ref
 * key_limit are taken to it. */
inline void
keysOf (const float* coordinates,
        std::size_t number,
        float voxels_per_meter,
        std::int32_t* keys)
{
  constexpr auto limit = static_cast<float> (key_limit);
  for (std::size_t i = 0; i < number; ++i) {
    // In this order NaN, of 0 in voxels too small for their inverse, becomes a limit.
    const float scaled =
        std::min (limit, std::max (-limit, coordinates[i] * voxels_per_meter));
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

inline MortonCode
mortonCode (std::int32_t x, std::int32_t y, std::int32_t z)
{
  const auto bits = [] (std::int32_t key) {
    return spreadBits (static_cast<std::uint32_t> (key + key_offset));
  };
  return bits (x) | bits (y) << 1 | bits (z) << 2;
}

/** \brief The numbers above zero that a code is made of: a key and \ref key_offset, of
 * a voxel of 2^n times the edge a 2^n-th of that. */
inline VoxelKey
numbersOf (MortonCode code)
{
  return {static_cast<std::int32_t> (gatherBits (code)),
          static_cast<std::int32_t> (gatherBits (code >> 1)),
          static_cast<std::int32_t> (gatherBits (code >> 2))};
}

} // namespace pcl_ops::internal

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

/** \brief The interleaved bits of a voxel's coordinates plus \ref key_offset: z, y, x
 * from the highest bit on, 20 bits of each. Sorted by code, voxels inside the same
 * larger voxel follow each other. The code divided by 8 is that of the enclosing voxel
 * of twice the edge. */
using MortonCode = std::uint64_t;

/** \brief Largest absolute value of a key: a coordinate of \ref VoxelKey [voxels]. */
constexpr std::int32_t key_limit = 1 << 18;

/** \brief Added to a key to make it positive; the sum is below 2^20. It is a multiple
 * of 1024, so that voxels of up to 1024 times the edge have a border at coordinate 0,
 * too. Its higher bits alternate, so that the keys just below 0 and those just above 0
 * share their upper bits: a radix sort skips the upper digits that all codes share. */
constexpr std::int32_t key_offset = 0x55400;

/** \brief Computes keys along one axis: coordinates [m] in voxels, rounded down and
 * clamped to -\ref key_limit .. \ref key_limit.
 * \param[out] keys \p count keys */
inline void
keysOf (const float* coordinates,
        std::size_t count,
        float voxels_per_meter,
        std::int32_t* keys)
{
  constexpr auto limit = static_cast<float> (key_limit);
  for (std::size_t i = 0; i < count; ++i) {
    // The coordinate 0 times infinite voxels_per_meter is NaN, which std::max with
    // arguments in this order turns into -limit.
    const float scaled =
        std::min (limit, std::max (-limit, coordinates[i] * voxels_per_meter));
    const auto truncated = static_cast<std::int32_t> (scaled);
    keys[i] = truncated - (scaled < static_cast<float> (truncated));
  }
}

/** \brief Moves bit i to bit 3 i, for the lowest 21 bits; all other bits become zero.
 * Each step halves the groups of bits that are still together. */
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

/** \brief Moves bit 3 i back to bit i: the inverse of \ref spreadBits. */
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

/** \brief Returns the Morton code of a voxel from its keys along the axes. */
inline MortonCode
mortonCode (std::int32_t x, std::int32_t y, std::int32_t z)
{
  const auto bits = [] (std::int32_t key) {
    return spreadBits (static_cast<std::uint32_t> (key + key_offset));
  };
  return bits (x) | bits (y) << 1 | bits (z) << 2;
}

/** \brief Decodes a Morton code: returns the key along each axis plus \ref key_offset.
 * For the code of a voxel of 2^n times the edge it returns this sum divided by 2^n and
 * rounded down. */
inline VoxelKey
shiftedKeyOf (MortonCode code)
{
  return {static_cast<std::int32_t> (gatherBits (code)),
          static_cast<std::int32_t> (gatherBits (code >> 1)),
          static_cast<std::int32_t> (gatherBits (code >> 2))};
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/point_sample.h"

#include "base/vectorized.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace pcl_ops::internal {

namespace {

// A number as good as drawn, but the same for a position wherever it stands, and in any
// unit that is a power of two: exponents are left out.
inline std::uint32_t
hashOf (float x, float y, float z)
{
  const auto bits = [] (float value) {
    constexpr std::uint32_t sign_and_mantissa = 0x807fffff;
    std::uint32_t same;
    std::memcpy (&same, &value, sizeof same);
    return same & sign_and_mantissa;
  };
  std::uint32_t hash =
      bits (x) * 0x9e3779b1u ^ bits (y) * 0x85ebca6bu ^ bits (z) * 0xc2b2ae35u;
  hash = (hash ^ hash >> 16) * 0x7feb352du;
  return hash ^ hash >> 15;
}

PCL_OPS_VECTORIZED void
hashAll (const float* x,
         const float* y,
         const float* z,
         std::size_t number,
         std::uint32_t* hashes)
{
  for (std::size_t i = 0; i < number; ++i)
    hashes[i] = hashOf (x[i], y[i], z[i]);
}

} // namespace

Coordinates
samplePoints (const Coordinates& positions, std::size_t wanted)
{
  constexpr std::size_t at_once = 1024;
  const auto share = static_cast<std::uint32_t> (positions.size() / wanted + 1);
  const std::uint32_t last_taken = std::numeric_limits<std::uint32_t>::max() / share;
  std::array<std::uint32_t, at_once> hashes;
  Coordinates some;
  for (std::size_t begin = 0; begin < positions.size(); begin += at_once) {
    const std::size_t number = std::min (at_once, positions.size() - begin);
    hashAll (&positions.x[begin],
             &positions.y[begin],
             &positions.z[begin],
             number,
             hashes.data());
    for (std::size_t i = 0; i < number; ++i)
      if (hashes[i] <= last_taken)
        some.add (
            positions.x[begin + i], positions.y[begin + i], positions.z[begin + i]);
  }
  return some;
}

} // namespace pcl_ops::internal

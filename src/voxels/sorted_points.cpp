// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/sorted_points.h"

#include "base/parallel.h"
#include "base/vectorized.h"

#include <algorithm>
#include <array>

namespace pcl_ops::internal {

namespace {

constexpr std::size_t batch = 512;

// Where voxels of a cloud begin to be counted.
struct KeyOrigin {
  std::int32_t x, y, z;
};

PCL_OPS_VECTORIZED void
codesOf (const float* x,
         const float* y,
         const float* z,
         std::size_t number,
         float voxels_per_metre,
         const KeyOrigin& origin,
         MortonCode* codes)
{
  std::array<std::int32_t, batch> key_x, key_y, key_z;
  keysOf (x, number, voxels_per_metre, key_x.data());
  keysOf (y, number, voxels_per_metre, key_y.data());
  keysOf (z, number, voxels_per_metre, key_z.data());
  for (std::size_t i = 0; i < number; ++i)
    codes[i] = mortonCode (static_cast<std::uint32_t> (key_x[i] - origin.x),
                           static_cast<std::uint32_t> (key_y[i] - origin.y),
                           static_cast<std::uint32_t> (key_z[i] - origin.z));
}

// The smallest key along an axis, or a little less: voxels of several times the edge
// begin there, too, wherever the cloud does.
std::int32_t
firstKey (const std::vector<float>& coordinates, float voxels_per_metre)
{
  constexpr std::int32_t edges = 16;
  const auto size = static_cast<Eigen::Index> (coordinates.size());
  const float smallest =
      Eigen::Map<const Eigen::ArrayXf> (coordinates.data(), size).minCoeff();
  std::int32_t key = 0;
  keysOf (&smallest, 1, voxels_per_metre, &key);
  return key & -edges;
}

// The runs of some of the points. Where one ends is found without a branch.
std::vector<PointRun>
runsOf (const Coordinates& positions,
        float voxels_per_metre,
        const KeyOrigin& origin,
        std::size_t begin,
        std::size_t end)
{
  std::array<MortonCode, batch> codes;
  std::array<std::uint32_t, batch + 1> run_begin;
  std::vector<PointRun> all;
  all.reserve (end - begin);
  for (std::size_t first = begin; first < end; first += batch) {
    const std::size_t number = std::min (batch, end - first);
    codesOf (&positions.x[first],
             &positions.y[first],
             &positions.z[first],
             number,
             voxels_per_metre,
             origin,
             codes.data());
    std::size_t runs = 0;
    run_begin[0] = 0;
    for (std::size_t i = 1; i < number; ++i) {
      run_begin[runs + 1] = static_cast<std::uint32_t> (i);
      runs += codes[i] != codes[i - 1];
    }
    run_begin[++runs] = static_cast<std::uint32_t> (number);
    for (std::size_t r = 0; r < runs; ++r)
      all.push_back ({codes[run_begin[r]],
                      static_cast<std::uint32_t> (first) + run_begin[r],
                      run_begin[r + 1] - run_begin[r]});
  }
  return all;
}

// Sorts by some of the bits of the code; equal ones stay in their order.
template <std::size_t digit_bits>
void
sortByDigit (const std::vector<PointRun>& runs,
             int lowest_bit,
             std::vector<PointRun>& sorted)
{
  constexpr std::size_t digits = std::size_t (1) << digit_bits;
  const auto digitOf = [lowest_bit] (const PointRun& run) {
    return run.code >> lowest_bit & (digits - 1);
  };
  std::array<std::uint32_t, digits + 1> next{};
  for (const PointRun& run : runs)
    ++next[digitOf (run) + 1];
  for (std::size_t digit = 1; digit < digits; ++digit)
    next[digit] += next[digit - 1];
  for (const PointRun& run : runs)
    sorted[next[digitOf (run)]++] = run;
}

// Radix sort, as far as codes reach.
void
sortByCode (std::vector<PointRun>& runs)
{
  constexpr int digit_bits = 8;
  MortonCode all_bits = 0;
  for (const PointRun& run : runs)
    all_bits |= run.code;
  std::vector<PointRun> sorted (runs.size());
  for (int bit = 0; bit < 64 && all_bits >> bit != 0; bit += digit_bits) {
    sortByDigit<digit_bits> (runs, bit, sorted);
    runs.swap (sorted);
  }
}

} // namespace

std::vector<PointRun>
sortedRuns (const Coordinates& positions, double voxel_size, unsigned threads)
{
  constexpr std::size_t points_per_piece = 32 * batch;
  if (positions.size() == 0)
    return {};
  const auto voxels_per_metre = static_cast<float> (1.0 / voxel_size);
  const KeyOrigin origin{firstKey (positions.x, voxels_per_metre),
                         firstKey (positions.y, voxels_per_metre),
                         firstKey (positions.z, voxels_per_metre)};
  const auto pieces = parallelPieces (
      threads, positions.size(), points_per_piece, [&] (auto begin, auto end) {
        return runsOf (positions, voxels_per_metre, origin, begin, end);
      });
  std::vector<PointRun> runs;
  for (const std::vector<PointRun>& piece : pieces)
    runs.insert (runs.end(), piece.begin(), piece.end());
  sortByCode (runs);
  return runs;
}

} // namespace pcl_ops::internal

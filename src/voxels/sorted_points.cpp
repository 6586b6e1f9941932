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

PCL_OPS_VECTORIZED void
codesOf (const float* x,
         const float* y,
         const float* z,
         std::size_t number,
         float voxels_per_meter,
         MortonCode* codes)
{
  std::array<std::int32_t, batch> key_x, key_y, key_z;
  keysOf (x, number, voxels_per_meter, key_x.data());
  keysOf (y, number, voxels_per_meter, key_y.data());
  keysOf (z, number, voxels_per_meter, key_z.data());
  for (std::size_t i = 0; i < number; ++i)
    codes[i] = mortonCode (key_x[i], key_y[i], key_z[i]);
}

// Writes the runs of some of the points. Where one ends is found without a branch.
// Returns their number.
std::size_t
findRuns (const Coordinates& positions,
          float voxels_per_meter,
          std::size_t begin,
          std::size_t end,
          PointRun* runs)
{
  std::array<MortonCode, batch> codes;
  std::size_t all = 0;
  for (std::size_t first = begin; first < end; first += batch) {
    const std::size_t number = std::min (batch, end - first);
    codesOf (&positions.x[first],
             &positions.y[first],
             &positions.z[first],
             number,
             voxels_per_meter,
             codes.data());
    for (std::size_t i = 0; i < number; ++i) {
      const bool is_new = i == 0 || codes[i] != codes[i - 1];
      all += is_new ? 1 : 0;
      PointRun& run = runs[all - 1];
      run.code = codes[i];
      run.first = is_new ? static_cast<std::uint32_t> (first + i) : run.first;
      run.size = is_new ? 1 : run.size + 1;
    }
  }
  return all;
}

// A type of its own, so that sorting calls it in place.
struct ComesFirst {
  bool
  operator() (const PointRun& a, const PointRun& b) const
  {
    return a.code != b.code ? a.code < b.code : a.first < b.first;
  }
};

constexpr int digit_bits = 8;
constexpr std::size_t digits = 1 << digit_bits;
constexpr std::ptrdiff_t few = 96;

/** \brief Where the runs of each digit begin, and where those of the last end. */
using DigitBounds = std::array<PointRun*, digits + 1>;

// Sorts runs by eight bits of their codes, in place (American flag sort: McIlroy,
// Bostic & McIlroy, Computing Systems 1993).
DigitBounds
permuteByDigit (PointRun* begin, PointRun* end, int lowest_bit)
{
  const int bit = std::max (0, lowest_bit);
  const auto digitOf = [bit] (const PointRun& run) {
    return static_cast<std::size_t> (run.code >> bit & (digits - 1));
  };
  std::array<std::ptrdiff_t, digits> number{};
  for (const PointRun* run = begin; run != end; ++run)
    ++number[digitOf (*run)];
  DigitBounds bounds;
  bounds[0] = begin;
  for (std::size_t digit = 0; digit < digits; ++digit)
    bounds[digit + 1] = bounds[digit] + number[digit];
  DigitBounds next = bounds;
  for (std::size_t digit = 0; digit < digits; ++digit)
    while (next[digit] != bounds[digit + 1]) {
      const std::size_t own = digitOf (*next[digit]);
      if (own == digit)
        ++next[digit];
      else
        std::swap (*next[digit], *next[own]++);
    }
  return bounds;
}

// Sorts runs whose codes have the same bits above lowest_bit + 8.
void
sortByDigits (PointRun* begin, PointRun* end, int lowest_bit)
{
  if (end - begin <= few || lowest_bit <= -digit_bits)
    return std::sort (begin, end, ComesFirst());
  const DigitBounds bounds = permuteByDigit (begin, end, lowest_bit);
  for (std::size_t digit = 0; digit < digits; ++digit)
    if (bounds[digit + 1] - bounds[digit] > 1)
      sortByDigits (bounds[digit], bounds[digit + 1], lowest_bit - digit_bits);
}

void
sortByCode (const PointRuns& runs, unsigned threads)
{
  MortonCode differing = 0;
  for (const PointRun& run : runs)
    differing |= run.code ^ runs[0].code;
  int bits = 0;
  while (differing >> bits != 0)
    ++bits;
  const int lowest_bit = bits - digit_bits;
  const DigitBounds bounds = permuteByDigit (runs.begin(), runs.end(), lowest_bit);
  parallelFor (threads, digits, 1, [&] (std::size_t digit, std::size_t) {
    sortByDigits (bounds[digit], bounds[digit + 1], lowest_bit - digit_bits);
  });
}

} // namespace

PointRuns
sortedRuns (const Coordinates& positions, double voxel_size, unsigned threads)
{
  constexpr std::size_t points_per_piece = 32 * batch;
  const auto voxels_per_meter = static_cast<float> (1.0 / voxel_size);
  // Each piece where its points are; then without gaps.
  PointRuns runs (positions.size());
  const std::vector<std::size_t> pieces = parallelChunks (
      threads, positions.size(), points_per_piece, [&] (auto begin, auto end) {
        return findRuns (positions, voxels_per_meter, begin, end, runs.begin() + begin);
      });
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const PointRun* const piece = runs.begin() + p * points_per_piece;
    std::copy (piece, piece + pieces[p], runs.end());
    runs.resize (runs.size() + pieces[p]);
  }
  sortByCode (runs, threads);
  return runs;
}

} // namespace pcl_ops::internal

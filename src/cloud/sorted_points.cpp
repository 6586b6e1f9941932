// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/sorted_points.h"

#include "base/parallel.h"
#include "base/radix_sort.h"
#include "base/vectorized.h"

#include <algorithm>
#include <array>
#include <utility>

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
  std::array<std::int32_t, batch> key_x;
  std::array<std::int32_t, batch> key_y;
  std::array<std::int32_t, batch> key_z;
  keysOf (x, number, voxels_per_meter, key_x.data());
  keysOf (y, number, voxels_per_meter, key_y.data());
  keysOf (z, number, voxels_per_meter, key_z.data());
  for (std::size_t i = 0; i < number; ++i)
    codes[i] = mortonCode (key_x[i], key_y[i], key_z[i]);
}

// Writes the runs of the points begin .. end - 1 and returns their number. Finds the
// ends of runs without a branch.
std::size_t
findRuns (const Coordinates& positions,
          float voxels_per_meter,
          std::size_t begin,
          std::size_t end,
          PointRun* runs)
{
  std::array<MortonCode, batch> codes;
  std::size_t all = 0;
  std::uint32_t run_begin = 0;
  for (std::size_t first = begin; first < end; first += batch) {
    const std::size_t number = std::min (batch, end - first);
    codesOf (&positions.x[first],
             &positions.y[first],
             &positions.z[first],
             number,
             voxels_per_meter,
             codes.data());
    for (std::size_t i = 0; i < number; ++i) {
      const auto point = static_cast<std::uint32_t> (first + i);
      const bool is_new =
          i == 0 || codes[i] != codes[i - 1] || point - run_begin == PointRun::max_size;
      all += is_new ? 1 : 0;
      run_begin = is_new ? point : run_begin;
      runs[all - 1] = PointRun (codes[i], run_begin, point - run_begin + 1);
    }
  }
  return all;
}

} // namespace

PointRuns
sortedRuns (const Coordinates& positions, double voxel_size, unsigned threads)
{
  constexpr std::size_t points_per_piece = 32 * batch;
  const auto voxels_per_meter = static_cast<float> (1.0 / voxel_size);
  // Each piece writes its runs from its first point's position on; then gaps close.
  PointRuns runs (positions.size(), boost::container::default_init);
  const std::vector<std::size_t> pieces = parallelChunks (
      threads, positions.size(), points_per_piece, [&] (auto begin, auto end) {
        return findRuns (positions, voxels_per_meter, begin, end, runs.data() + begin);
      });
  PointRun* last = runs.data();
  for (std::size_t p = 0; p < pieces.size(); ++p)
    last = std::copy_n (runs.data() + p * points_per_piece, pieces[p], last);
  runs.resize (static_cast<std::size_t> (last - runs.data()));
  PointRuns spare (runs.size(), boost::container::default_init);
  const auto codeOf = [] (const PointRun& run) { return run.code(); };
  const PointRun* const sorted =
      radixSort (threads, runs.data(), runs.size(), spare.data(), codeOf);
  return sorted == runs.data() ? std::move (runs) : std::move (spare);
}

} // namespace pcl_ops::internal

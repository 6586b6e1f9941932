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

// Number of points whose codes are computed at once: chosen by hand, changes only the
// time.
constexpr std::size_t points_of_batch = 512;

// Computes the Morton codes of the voxels of up to points_of_batch points.
PCL_OPS_VECTORIZED void
computeCodes (const float* x,
              const float* y,
              const float* z,
              std::size_t count,
              float voxels_per_meter,
              MortonCode* codes)
{
  std::array<std::int32_t, points_of_batch> key_x;
  std::array<std::int32_t, points_of_batch> key_y;
  std::array<std::int32_t, points_of_batch> key_z;
  keysOf (x, count, voxels_per_meter, key_x.data());
  keysOf (y, count, voxels_per_meter, key_y.data());
  keysOf (z, count, voxels_per_meter, key_z.data());
  for (std::size_t i = 0; i < count; ++i)
    codes[i] = mortonCode (key_x[i], key_y[i], key_z[i]);
}

// Writes the runs of the points begin .. end - 1 and returns their number. There is no
// branch to mispredict: each point writes the run up to itself, over the run of the
// point before unless it begins a new run. A batch of points_of_batch points begins a
// new run.
std::size_t
findRuns (const Coordinates& positions,
          float voxels_per_meter,
          std::size_t begin,
          std::size_t end,
          PointRun* runs)
{
  std::array<MortonCode, points_of_batch> codes;
  std::size_t runs_so_far = 0;
  std::uint32_t run_begin = 0;
  for (std::size_t batch = begin; batch < end; batch += points_of_batch) {
    const std::size_t count = std::min (points_of_batch, end - batch);
    computeCodes (&positions.x[batch],
                  &positions.y[batch],
                  &positions.z[batch],
                  count,
                  voxels_per_meter,
                  codes.data());
    for (std::size_t i = 0; i < count; ++i) {
      const auto point = static_cast<std::uint32_t> (batch + i);
      const bool begins_run =
          i == 0 || codes[i] != codes[i - 1] || point - run_begin == PointRun::max_size;
      runs_so_far += begins_run ? 1 : 0;
      run_begin = begins_run ? point : run_begin;
      runs[runs_so_far - 1] = PointRun (codes[i], run_begin, point - run_begin + 1);
    }
  }
  return runs_so_far;
}

} // namespace

PointRuns
sortedRuns (const Coordinates& positions, double voxel_size, unsigned threads)
{
  constexpr std::size_t points_per_piece = 32 * points_of_batch;
  const auto voxels_per_meter = static_cast<float> (1.0 / voxel_size);
  // Each piece writes its runs from the index of its first point on. Then the runs of
  // all pieces are moved together, without the unused elements between them.
  PointRuns runs (positions.size(), boost::container::default_init);
  const std::vector<std::size_t> runs_of_piece = parallelPieces (
      threads,
      positions.size(),
      points_per_piece,
      [&] (std::size_t begin, std::size_t end) {
        return findRuns (positions, voxels_per_meter, begin, end, &runs[begin]);
      });
  PointRun* end_of_runs = runs.data();
  for (std::size_t piece = 0; piece < runs_of_piece.size(); ++piece)
    end_of_runs = std::copy_n (
        runs.data() + piece * points_per_piece, runs_of_piece[piece], end_of_runs);
  runs.resize (static_cast<std::size_t> (end_of_runs - runs.data()));
  PointRuns spare (runs.size(), boost::container::default_init);
  const auto codeOf = [] (const PointRun& run) { return run.code(); };
  const PointRun* const sorted =
      radixSort (threads, runs.data(), runs.size(), spare.data(), codeOf);
  return sorted == runs.data() ? std::move (runs) : std::move (spare);
}

} // namespace pcl_ops::internal

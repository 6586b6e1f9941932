// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/voxel_grid.h"

#include "base/parallel.h"
#include "geometry/point_sample.h"
#include "voxels/voxel_keys.h"
#include "voxels/voxel_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl_ops::internal {

namespace {

struct Piece {
  VoxelTable table;
  std::vector<Moments> moments;
};

// Sums in local variables, which stay in registers.
void
addPositions (const Coordinates& positions,
              std::size_t begin,
              std::size_t end,
              Moments& moments)
{
  double sx = 0, sy = 0, sz = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const double x = positions.x[i], y = positions.y[i], z = positions.z[i];
    sx += x;
    sy += y;
    sz += z;
    xx += x * x;
    xy += x * y;
    xz += x * z;
    yy += y * y;
    yz += y * z;
    zz += z * z;
  }
  moments.addAligned ({moments.origin,
                       static_cast<double> (end - begin),
                       {sx, sy, sz},
                       {xx, xy, xz, yy, yz, zz}});
}

void
addPoints (const Coordinates& positions,
           double voxel_size,
           std::size_t begin,
           std::size_t end,
           Piece& piece,
           std::vector<std::uint32_t>& voxel_of_point)
{
  constexpr std::size_t usual_points_per_voxel = 8;
  piece.moments.reserve ((end - begin) / usual_points_per_voxel + 1);
  forRuns (positions,
           voxel_size,
           begin,
           end,
           [&] (std::size_t first, std::size_t last, const VoxelKey& key) {
             const std::uint32_t voxel = piece.table.insert (key);
             if (voxel == piece.moments.size())
               piece.moments.emplace_back();
             addPositions (positions, first, last, piece.moments[voxel]);
             std::fill (voxel_of_point.begin() + static_cast<std::ptrdiff_t> (first),
                        voxel_of_point.begin() + static_cast<std::ptrdiff_t> (last),
                        voxel);
           });
}

// Adds voxels with their moments to a grid's table; returns where each went.
std::vector<std::uint32_t>
insertAll (const std::vector<VoxelKey>& keys,
           const std::vector<Moments>& added,
           VoxelTable& table,
           std::vector<Moments>& moments)
{
  std::vector<std::uint32_t> voxel_of (keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    voxel_of[i] = table.insert (keys[i]);
    if (voxel_of[i] == moments.size())
      moments.emplace_back();
    moments[voxel_of[i]].addAligned (added[i]);
  }
  return voxel_of;
}

// Adds the voxels of all pieces to the first, and empties the others, as large together
// where each point has a voxel of its own; returns for each piece where its voxels are.
std::vector<std::vector<std::uint32_t>>
joinIntoFirst (std::vector<Piece>& pieces)
{
  std::vector<std::vector<std::uint32_t>> voxel_of (pieces.size());
  voxel_of[0].resize (pieces[0].moments.size());
  std::iota (voxel_of[0].begin(), voxel_of[0].end(), 0u);
  for (std::size_t p = 1; p < pieces.size(); ++p) {
    voxel_of[p] = insertAll (
        pieces[p].table.keys(), pieces[p].moments, pieces[0].table, pieces[0].moments);
    pieces[p] = Piece();
  }
  return voxel_of;
}

// In place: a second copy would be the peak of memory where points are far apart.
void
moveTo (std::vector<std::uint32_t> position, std::vector<Moments>& moments)
{
  for (std::uint32_t i = 0; i < position.size(); ++i)
    while (position[i] != i) {
      const std::uint32_t to = position[i];
      std::swap (moments[i], moments[to]);
      std::swap (position[i], position[to]);
    }
}

// Puts the voxels in the table's order, their moments into the grid; returns the new
// position of each.
std::vector<std::uint32_t>
finish (VoxelTable& table,
        std::vector<Moments>& moments,
        unsigned threads,
        VoxelGrid& grid)
{
  std::vector<std::uint32_t> order = table.sort();
  grid.keys = table.keys();
  moveTo (order, moments);
  grid.moments = std::move (moments);
  grid.neighbours = table.neighbours (threads);
  return order;
}

std::size_t
countOccupied (const Coordinates& positions, double voxel_size)
{
  VoxelTable table;
  forRuns (
      positions,
      voxel_size,
      0,
      positions.size(),
      [&table] (std::size_t, std::size_t, const VoxelKey& key) { table.insert (key); });
  return table.size();
}

// Without what lies many times farther from the origin, which is near most points, than
// half of them do: outliers would fill a voxel each, however large.
Coordinates
withoutOutliers (const Coordinates& positions)
{
  constexpr double medians = 32.0;
  std::vector<float> distances;
  distances.reserve (positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    distances.push_back (static_cast<float> (positions[i].norm()));
  const double limit = medians * medianOf (distances);
  Coordinates kept;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!(positions[i].norm() > limit))
      kept.add (positions.x[i], positions.y[i], positions.z[i]);
  return kept;
}

double
diagonal (const Coordinates& positions)
{
  Eigen::Vector3d low = positions[0], high = positions[0];
  for (std::size_t i = 0; i < positions.size(); ++i) {
    low = low.cwiseMin (positions[i]);
    high = high.cwiseMax (positions[i]);
  }
  return (high - low).norm();
}

} // namespace

double
voxelSizeFor (const Coordinates& positions, double wanted_voxels)
{
  constexpr std::size_t looked_at = 8192;
  // Several of the points looked at share a voxel: an empty one is empty indeed.
  constexpr double counted_voxels = 800.0;
  if (positions.size() == 0)
    return 0.0;
  const Coordinates some = withoutOutliers (samplePoints (positions, looked_at));
  if (some.size() == 0)
    return 0.0;
  double voxel_size = diagonal (some) / 25.0;
  if (!(voxel_size > 0.0 && std::isfinite (voxel_size)))
    return 0.0;
  constexpr int most_tries = 8;
  double counted = 0.0;
  for (int i = 0; i < most_tries; ++i) {
    counted = static_cast<double> (countOccupied (some, voxel_size));
    const double ratio = counted / std::min (counted_voxels, wanted_voxels);
    if (ratio > 0.5 && ratio < 2.0)
      break;
    voxel_size *= std::sqrt (ratio);
  }
  return voxel_size * std::sqrt (counted / wanted_voxels);
}

VoxelizedPoints
voxelize (const Coordinates& positions, double voxel_size, unsigned threads)
{
  constexpr std::size_t points_per_piece = 49152;
  constexpr std::size_t most_pieces = 4;
  const std::size_t number =
      std::clamp (positions.size() / points_per_piece, std::size_t (1), most_pieces);
  const std::size_t grain =
      std::max<std::size_t> (1, (positions.size() + number - 1) / number);
  std::vector<Piece> pieces (number);
  VoxelizedPoints voxelized;
  voxelized.voxel_of_point.resize (positions.size());
  parallelFor (
      threads, positions.size(), grain, [&] (std::size_t begin, std::size_t end) {
        addPoints (positions,
                   voxel_size,
                   begin,
                   end,
                   pieces[begin / grain],
                   voxelized.voxel_of_point);
      });
  std::vector<std::vector<std::uint32_t>> voxel_of = joinIntoFirst (pieces);
  voxelized.grid.voxel_size = voxel_size;
  const std::vector<std::uint32_t> order =
      finish (pieces[0].table, pieces[0].moments, threads, voxelized.grid);
  for (std::vector<std::uint32_t>& piece : voxel_of)
    for (std::uint32_t& voxel : piece)
      voxel = order[voxel];
  parallelFor (
      threads, positions.size(), grain, [&] (std::size_t begin, std::size_t end) {
        const std::vector<std::uint32_t>& new_voxel = voxel_of[begin / grain];
        for (std::size_t i = begin; i < end; ++i)
          voxelized.voxel_of_point[i] = new_voxel[voxelized.voxel_of_point[i]];
      });
  return voxelized;
}

CoarserGrid
coarsen (const VoxelGrid& finer, unsigned threads)
{
  std::vector<VoxelKey> keys (finer.size());
  std::transform (
      finer.keys.begin(), finer.keys.end(), keys.begin(), [] (const VoxelKey& key) {
        return VoxelKey{key.x >> 1, key.y >> 1, key.z >> 1};
      });
  CoarserGrid coarser;
  coarser.grid.voxel_size = 2.0 * finer.voxel_size;
  VoxelTable table;
  std::vector<Moments> moments;
  coarser.voxel_of_finer = insertAll (keys, finer.moments, table, moments);
  const std::vector<std::uint32_t> order =
      finish (table, moments, threads, coarser.grid);
  for (std::uint32_t& voxel : coarser.voxel_of_finer)
    voxel = order[voxel];
  return coarser;
}

} // namespace pcl_ops::internal

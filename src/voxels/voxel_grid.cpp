// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_keys.h"
#include "cell_table.h"
#include <pcl_ops/cell_grid.h>
#include <pcl_ops/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pcl_ops {

namespace {

struct Piece {
  CellTable table;
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
           double cell_size,
           std::size_t begin,
           std::size_t end,
           Piece& piece,
           std::vector<std::uint32_t>& cell_of_point)
{
  constexpr std::size_t usual_points_per_cell = 8;
  piece.moments.reserve ((end - begin) / usual_points_per_cell + 1);
  forRuns (positions,
           cell_size,
           begin,
           end,
           [&] (std::size_t first, std::size_t last, const CellKey& key) {
             const std::uint32_t cell = piece.table.insert (key);
             if (cell == piece.moments.size())
               piece.moments.emplace_back();
             addPositions (positions, first, last, piece.moments[cell]);
             std::fill (cell_of_point.begin() + static_cast<std::ptrdiff_t> (first),
                        cell_of_point.begin() + static_cast<std::ptrdiff_t> (last),
                        cell);
           });
}

// Adds cells with their moments to a grid's table; returns where each went.
std::vector<std::uint32_t>
insertAll (const std::vector<CellKey>& keys,
           const std::vector<Moments>& added,
           CellTable& table,
           std::vector<Moments>& moments)
{
  std::vector<std::uint32_t> cell_of (keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    cell_of[i] = table.insert (keys[i]);
    if (cell_of[i] == moments.size())
      moments.emplace_back();
    moments[cell_of[i]].addAligned (added[i]);
  }
  return cell_of;
}

// Adds the cells of all pieces to the first; returns for each piece where its cells
// are.
std::vector<std::vector<std::uint32_t>>
joinIntoFirst (std::vector<Piece>& pieces)
{
  std::vector<std::vector<std::uint32_t>> cell_of (pieces.size());
  cell_of[0].resize (pieces[0].moments.size());
  std::iota (cell_of[0].begin(), cell_of[0].end(), 0u);
  for (std::size_t p = 1; p < pieces.size(); ++p)
    cell_of[p] = insertAll (
        pieces[p].table.keys(), pieces[p].moments, pieces[0].table, pieces[0].moments);
  return cell_of;
}

// Puts the cells in the table's order; returns the new position of each.
std::vector<std::uint32_t>
finish (CellTable& table,
        std::vector<Moments>& moments,
        unsigned threads,
        CellGrid& grid)
{
  std::vector<std::uint32_t> order = table.sort();
  grid.keys = table.keys();
  grid.moments.resize (moments.size());
  for (std::size_t i = 0; i < moments.size(); ++i)
    grid.moments[order[i]] = moments[i];
  grid.neighbours = table.neighbours (threads);
  return order;
}

// Some of the points, evenly spread over their order.
Coordinates
someOf (const Coordinates& positions, std::size_t wanted)
{
  const std::size_t stride = positions.size() / wanted + 1;
  Coordinates some;
  for (std::size_t i = 0; i < positions.size(); i += stride)
    some.add (positions.x[i], positions.y[i], positions.z[i]);
  return some;
}

std::size_t
countOccupied (const Coordinates& positions, double cell_size)
{
  CellTable table;
  forRuns (
      positions,
      cell_size,
      0,
      positions.size(),
      [&table] (std::size_t, std::size_t, const CellKey& key) { table.insert (key); });
  return table.size();
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
cellSizeFor (const Coordinates& positions, double wanted_cells)
{
  constexpr std::size_t looked_at = 8192;
  // Several of the points looked at share a cell: an empty one is empty indeed.
  constexpr double counted_cells = 800.0;
  if (positions.size() == 0)
    return 0.0;
  const Coordinates some = someOf (positions, looked_at);
  double cell_size = diagonal (some) / 25.0;
  if (!(cell_size > 0.0 && std::isfinite (cell_size)))
    return 0.0;
  constexpr int most_tries = 8;
  double counted = 0.0;
  for (int i = 0; i < most_tries; ++i) {
    counted = static_cast<double> (countOccupied (some, cell_size));
    const double ratio = counted / std::min (counted_cells, wanted_cells);
    if (ratio > 0.5 && ratio < 2.0)
      break;
    cell_size *= std::sqrt (ratio);
  }
  return cell_size * std::sqrt (counted / wanted_cells);
}

GriddedPoints
gridPoints (const Coordinates& positions, double cell_size, unsigned threads)
{
  constexpr std::size_t points_per_piece = 131072;
  constexpr std::size_t most_pieces = 4;
  const std::size_t number =
      std::clamp (positions.size() / points_per_piece, std::size_t (1), most_pieces);
  const std::size_t grain =
      std::max<std::size_t> (1, (positions.size() + number - 1) / number);
  std::vector<Piece> pieces (number);
  GriddedPoints gridded;
  gridded.cell_of_point.resize (positions.size());
  parallelFor (
      threads, positions.size(), grain, [&] (std::size_t begin, std::size_t end) {
        addPoints (positions,
                   cell_size,
                   begin,
                   end,
                   pieces[begin / grain],
                   gridded.cell_of_point);
      });
  std::vector<std::vector<std::uint32_t>> cell_of = joinIntoFirst (pieces);
  gridded.grid.cell_size = cell_size;
  const std::vector<std::uint32_t> order =
      finish (pieces[0].table, pieces[0].moments, threads, gridded.grid);
  for (std::vector<std::uint32_t>& piece : cell_of)
    for (std::uint32_t& cell : piece)
      cell = order[cell];
  parallelFor (
      threads, positions.size(), grain, [&] (std::size_t begin, std::size_t end) {
        const std::vector<std::uint32_t>& new_cell = cell_of[begin / grain];
        for (std::size_t i = begin; i < end; ++i)
          gridded.cell_of_point[i] = new_cell[gridded.cell_of_point[i]];
      });
  return gridded;
}

CoarserGrid
coarsen (const CellGrid& finer, unsigned threads)
{
  std::vector<CellKey> keys (finer.size());
  std::transform (
      finer.keys.begin(), finer.keys.end(), keys.begin(), [] (const CellKey& key) {
        return CellKey{key.x >> 1, key.y >> 1, key.z >> 1};
      });
  CoarserGrid coarser;
  coarser.grid.cell_size = 2.0 * finer.cell_size;
  CellTable table;
  std::vector<Moments> moments;
  coarser.cell_of_finer = insertAll (keys, finer.moments, table, moments);
  const std::vector<std::uint32_t> order =
      finish (table, moments, threads, coarser.grid);
  for (std::uint32_t& cell : coarser.cell_of_finer)
    cell = order[cell];
  return coarser;
}

} // namespace pcl_ops

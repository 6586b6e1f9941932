// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_table.h"
#include <pcl_ops/cell_grid.h>
#include <pcl_ops/parallel.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

namespace {

constexpr double key_range = 1048576.0;

std::int32_t
keyOf (float coordinate, double cells_per_metre)
{
  // Shifted above zero so that the conversion, which truncates, rounds down.
  const double shifted = static_cast<double> (coordinate) * cells_per_metre + key_range;
  return static_cast<std::int32_t> (
      std::min (std::max (shifted, 0.0), 2.0 * key_range - 1.0));
}

CellKey
keyOf (const Coordinates& positions, std::size_t i, double cells_per_metre)
{
  return {keyOf (positions.x[i], cells_per_metre),
          keyOf (positions.y[i], cells_per_metre),
          keyOf (positions.z[i], cells_per_metre)};
}

struct Piece {
  CellTable table;
  std::vector<Moments> moments;
};

void
addPoints (const Coordinates& positions,
           double cells_per_metre,
           std::size_t begin,
           std::size_t end,
           Piece& piece,
           std::vector<std::uint32_t>& cell_of_point)
{
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t cell =
        piece.table.insert (keyOf (positions, i, cells_per_metre));
    if (cell == piece.moments.size())
      piece.moments.emplace_back();
    piece.moments[cell].add (positions.x[i], positions.y[i], positions.z[i]);
    cell_of_point[i] = cell;
  }
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
    moments[cell_of[i]] += added[i];
  }
  return cell_of;
}

// Puts the cells in the table's order; returns the new position of each.
std::vector<std::uint32_t>
finish (CellTable& table, std::vector<Moments>& moments, CellGrid& grid)
{
  const std::vector<std::uint32_t> order = table.sort();
  grid.keys = table.keys();
  grid.moments.resize (moments.size());
  for (std::size_t i = 0; i < moments.size(); ++i)
    grid.moments[order[i]] = moments[i];
  grid.neighbours = table.neighbourhoods();
  return order;
}

std::size_t
countOccupied (const Coordinates& positions, std::size_t stride, double cell_size)
{
  CellTable table;
  for (std::size_t i = 0; i < positions.size(); i += stride)
    table.insert (keyOf (positions, i, 1.0 / cell_size));
  return table.size();
}

double
diagonal (const Coordinates& positions, std::size_t stride)
{
  Eigen::Vector3d low = positions[0], high = positions[0];
  for (std::size_t i = 0; i < positions.size(); i += stride) {
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
  const std::size_t stride = positions.size() / looked_at + 1;
  double cell_size = diagonal (positions, stride) / 25.0;
  if (!(cell_size > 0.0 && std::isfinite (cell_size)))
    return 0.0;
  constexpr int most_tries = 8;
  double counted = 0.0;
  for (int i = 0; i < most_tries; ++i) {
    counted = static_cast<double> (countOccupied (positions, stride, cell_size));
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
  constexpr std::size_t smallest_piece = 131072;
  constexpr std::size_t most_pieces = 8;
  const std::size_t grain =
      std::max (smallest_piece, (positions.size() + most_pieces - 1) / most_pieces);
  std::vector<Piece> pieces ((positions.size() + grain - 1) / grain);
  GriddedPoints gridded;
  gridded.cell_of_point.resize (positions.size());
  parallelFor (
      threads, positions.size(), grain, [&] (std::size_t begin, std::size_t end) {
        addPoints (positions,
                   1.0 / cell_size,
                   begin,
                   end,
                   pieces[begin / grain],
                   gridded.cell_of_point);
      });
  CellTable table;
  std::vector<Moments> moments;
  std::vector<std::vector<std::uint32_t>> cell_of;
  for (const Piece& piece : pieces)
    cell_of.push_back (insertAll (piece.table.keys(), piece.moments, table, moments));
  gridded.grid.cell_size = cell_size;
  const std::vector<std::uint32_t> order = finish (table, moments, gridded.grid);
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
coarsen (const CellGrid& finer)
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
  const std::vector<std::uint32_t> order = finish (table, moments, coarser.grid);
  for (std::uint32_t& cell : coarser.cell_of_finer)
    cell = order[cell];
  return coarser;
}

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_support.h"
#include "cell_units.h"

#include <algorithm>
#include <optional>

namespace pcl_ops {

namespace {

struct Adoption {
  std::size_t cell;
  std::int32_t plane;
  double noise;
};

// The plane next to a cell that its points are nearest to, in units of the limit there.
std::optional<Adoption>
adoptingPlane (const CellGrid& grid,
               const GrowingParameters& parameters,
               double limit,
               const CellPlanes& planes,
               std::size_t cell)
{
  std::optional<Adoption> adoption;
  double best = 1.0;
  // Neighbours in a row mostly are on the same plane.
  std::optional<std::size_t> last;
  double squared = 0.0;
  forNeighboursOnPlanes (
      grid, planes.plane_of_cell, cell, [&] (std::size_t plane, std::size_t neighbour) {
        const double band =
            std::min (parameters.noise_factor * planes.noise[neighbour], limit);
        if (plane != last)
          squared = meanSquaredDistance (grid.moments[cell], planes.planes[plane]);
        last = plane;
        const double ratio = squared / (band * band);
        if (ratio >= best)
          return;
        best = ratio;
        adoption = {cell, static_cast<std::int32_t> (plane), planes.noise[neighbour]};
      });
  return adoption;
}

std::vector<Adoption>
adoptionsOf (const std::vector<std::size_t>& cells,
             const CellGrid& grid,
             const GrowingParameters& parameters,
             double limit,
             const CellPlanes& planes,
             unsigned threads)
{
  std::vector<Adoption> all;
  for (const std::vector<Adoption>&piece : parallelPieces (
           threads, cells.size(), cells_per_piece, [&] (auto begin, auto end) {
             std::vector<Adoption> adoptions;
             for (std::size_t i = begin; i < end; ++i)
               if (const auto adoption =
                       adoptingPlane (grid, parameters, limit, planes, cells[i]))
                 adoptions.push_back (*adoption);
             return adoptions;
           }))
    all.insert (all.end(), piece.begin(), piece.end());
  return all;
}

std::vector<std::size_t>
cellsOffPlanes (const Labels& plane_of_cell)
{
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < plane_of_cell.size(); ++i)
    if (plane_of_cell[i] == no_plane)
      cells.push_back (i);
  return cells;
}

// The cells off planes that touch an adopted one, ascending.
std::vector<std::size_t>
cellsNextTo (const CellGrid& grid,
             const std::vector<Adoption>& adoptions,
             const Labels& plane_of_cell)
{
  std::vector<std::size_t> cells;
  for (const Adoption& adoption : adoptions)
    for (const std::uint32_t neighbour : grid.neighbours[adoption.cell])
      if (plane_of_cell[neighbour] == no_plane)
        cells.push_back (neighbour);
  std::sort (cells.begin(), cells.end());
  cells.erase (std::unique (cells.begin(), cells.end()), cells.end());
  return cells;
}

} // namespace

void
growPlanes (const CellGrid& grid,
            const GrowingParameters& parameters,
            unsigned threads,
            CellPlanes& planes)
{
  const double limit = distanceLimit (grid, parameters.distance_threshold);
  std::vector<std::size_t> border = cellsOffPlanes (planes.plane_of_cell);
  for (int round = 0; round < parameters.rounds && !border.empty(); ++round) {
    const std::vector<Adoption> adoptions =
        adoptionsOf (border, grid, parameters, limit, planes, threads);
    for (const Adoption& adoption : adoptions) {
      planes.plane_of_cell[adoption.cell] = adoption.plane;
      planes.noise[adoption.cell] = adoption.noise;
    }
    border = cellsNextTo (grid, adoptions, planes.plane_of_cell);
  }
  refitPlanes (grid, planes);
}

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_support.h"
#include "cell_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pcl_ops {

void
refitPlanes (const CellGrid& grid, CellPlanes& planes)
{
  const std::vector<Moments> moments = momentsOfPlanes (grid, planes);
  for (std::size_t p = 0; p < moments.size(); ++p)
    if (const std::optional<PlaneFit> fit = fitPlane (moments[p]))
      planes.planes[p] = fit->plane;
}

void
measureNoise (const CellGrid& grid, unsigned threads, CellPlanes& planes)
{
  // Of each cell's points: the sum of squared distances, and how many they are.
  std::vector<std::array<double, 2>> distances (grid.size());
  forCells (grid, threads, [&] (std::size_t i) {
    if (planes.plane_of_cell[i] == no_plane)
      return;
    const Moments& cell = grid.moments[i];
    const auto own = static_cast<std::size_t> (planes.plane_of_cell[i]);
    distances[i] = {cell.count * meanSquaredDistance (cell, planes.planes[own]),
                    cell.count};
  });
  forCells (grid, threads, [&] (std::size_t i) {
    if (planes.plane_of_cell[i] == no_plane)
      return;
    double sum = 0.0;
    double count = 0.0;
    for (const std::uint32_t neighbour : grid.neighbours[i])
      if (planes.plane_of_cell[neighbour] == planes.plane_of_cell[i]) {
        sum += distances[neighbour][0];
        count += distances[neighbour][1];
      }
    planes.noise[i] = std::max (std::sqrt (sum / count), smallestNoise (grid));
  });
}

void
reassignCells (const CellGrid& grid, unsigned threads, CellPlanes& planes)
{
  const Labels before = planes.plane_of_cell;
  forCells (grid, threads, [&] (std::size_t i) {
    if (before[i] == no_plane)
      return;
    const auto own = static_cast<std::size_t> (before[i]);
    // Computed when another plane is met: most cells have their own all around.
    std::optional<double> best;
    std::size_t last = own;
    forNeighboursOnPlanes (grid, before, i, [&] (std::size_t plane, std::size_t) {
      if (plane == own || plane == last)
        return;
      last = plane;
      if (!best)
        best = meanSquaredDistance (grid.moments[i], planes.planes[own]);
      const double squared =
          meanSquaredDistance (grid.moments[i], planes.planes[plane]);
      if (squared >= *best)
        return;
      best = squared;
      planes.plane_of_cell[i] = static_cast<std::int32_t> (plane);
    });
  });
  refitPlanes (grid, planes);
}

std::vector<Moments>
momentsOfPlanes (const CellGrid& grid, const CellPlanes& planes)
{
  std::vector<Moments> moments (planes.planes.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes.plane_of_cell[i] != no_plane)
      moments[static_cast<std::size_t> (planes.plane_of_cell[i])].addAligned (
          grid.moments[i]);
  return moments;
}

void
renumberPlanes (const MergedPlanes& merged, CellPlanes& planes)
{
  relabel (planes.plane_of_cell, merged.merged_into, 1);
  planes.planes.clear();
  for (const PlaneFit& fit : merged.fits)
    planes.planes.push_back (fit.plane);
}

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_support.h"
#include "cell_units.h"

#include <algorithm>
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
measureNoise (const CellGrid& grid, CellPlanes& planes)
{
  std::vector<double> squared (grid.size(), 0.0);
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes.plane_of_cell[i] != no_plane)
      squared[i] = meanSquaredDistance (
          grid.moments[i],
          planes.planes[static_cast<std::size_t> (planes.plane_of_cell[i])]);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (planes.plane_of_cell[i] == no_plane)
      continue;
    const auto own = static_cast<std::size_t> (planes.plane_of_cell[i]);
    double sum = 0.0;
    double count = 0.0;
    forNeighboursOnPlanes (
        grid, planes.plane_of_cell, i, [&] (std::size_t plane, std::size_t neighbour) {
          if (plane != own)
            return;
          sum += grid.moments[neighbour].count * squared[neighbour];
          count += grid.moments[neighbour].count;
        });
    planes.noise[i] = std::max (std::sqrt (sum / count), smallestNoise (grid));
  }
}

void
reassignCells (const CellGrid& grid, CellPlanes& planes)
{
  const Labels before = planes.plane_of_cell;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (before[i] == no_plane)
      continue;
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
  }
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

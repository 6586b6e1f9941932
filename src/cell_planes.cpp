// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_units.h"
#include <pcl_ops/cell_planes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace pcl_ops {

namespace {

// Calls visit (plane, neighbour) for each neighbour of a cell that is on a plane.
template <typename Visit>
void
forNeighboursOnPlanes (const CellGrid& grid,
                       const Labels& plane_of_cell,
                       std::size_t cell,
                       Visit&& visit)
{
  for (const std::uint32_t neighbour : grid.neighbours[cell])
    if (const std::int32_t plane = plane_of_cell[neighbour]; plane != no_plane)
      visit (static_cast<std::size_t> (plane), std::size_t (neighbour));
}

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
  forNeighboursOnPlanes (
      grid, planes.plane_of_cell, cell, [&] (std::size_t plane, std::size_t neighbour) {
        const double band =
            std::min (parameters.noise_factor * planes.noise[neighbour], limit);
        const double ratio =
            meanSquaredDistance (grid.moments[cell], planes.planes[plane]) /
            (band * band);
        if (ratio >= best)
          return;
        best = ratio;
        adoption = {cell, static_cast<std::int32_t> (plane), planes.noise[neighbour]};
      });
  return adoption;
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

void
refitPlanes (const CellGrid& grid, CellPlanes& planes)
{
  const std::vector<Moments> moments = momentsOfPlanes (grid, planes);
  for (std::size_t p = 0; p < moments.size(); ++p)
    if (const std::optional<PlaneFit> fit = fitPlane (moments[p]))
      planes.planes[p] = fit->plane;
}

// Follows a chain of absorptions to its end and closes the gaps it leaves.
std::pair<Labels, std::size_t>
closeGaps (const std::vector<std::size_t>& goes_into)
{
  Labels merged_into (goes_into.size(), no_plane);
  std::size_t number = 0;
  for (std::size_t p = 0; p < goes_into.size(); ++p)
    if (goes_into[p] == p)
      merged_into[p] = static_cast<std::int32_t> (number++);
  for (std::size_t p = 0; p < goes_into.size(); ++p) {
    std::size_t last = p;
    while (goes_into[last] != last)
      last = goes_into[last];
    merged_into[p] = merged_into[last];
  }
  return {merged_into, number};
}

// A stretch of border between a plane and a larger one, with the larger one's noise.
struct Border {
  std::size_t smaller;
  std::size_t larger;
  double squared_noise;
  double cells;
};

bool
isBefore (const Border& first, const Border& second)
{
  return std::tie (first.smaller, first.larger) <
         std::tie (second.smaller, second.larger);
}

// Joins stretches of the same border.
std::vector<Border>
joined (std::vector<Border> stretches)
{
  std::stable_sort (stretches.begin(), stretches.end(), isBefore);
  std::vector<Border> borders;
  for (const Border& stretch : stretches)
    if (borders.empty() || isBefore (borders.back(), stretch))
      borders.push_back (stretch);
    else {
      borders.back().squared_noise += stretch.squared_noise;
      borders.back().cells += stretch.cells;
    }
  return borders;
}

std::vector<Border>
bordersOf (const CellGrid& grid,
           const CellPlanes& planes,
           const std::vector<Moments>& moments)
{
  std::vector<Border> stretches;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (planes.plane_of_cell[i] == no_plane)
      continue;
    const auto own = static_cast<std::size_t> (planes.plane_of_cell[i]);
    forNeighboursOnPlanes (
        grid, planes.plane_of_cell, i, [&] (std::size_t other, std::size_t neighbour) {
          if (other == own || moments[other].count < moments[own].count)
            return;
          const double noise = planes.noise[neighbour];
          stretches.push_back ({own, other, noise * noise, 1.0});
        });
  }
  return joined (std::move (stretches));
}

// One round of absorptions; false if there was none.
bool
absorbOnce (const CellGrid& grid, double noise_factor, CellPlanes& planes)
{
  const std::vector<Moments> moments = momentsOfPlanes (grid, planes);
  std::vector<std::size_t> goes_into (moments.size());
  std::vector<double> best (moments.size(), noise_factor * noise_factor);
  for (std::size_t p = 0; p < goes_into.size(); ++p)
    goes_into[p] = p;
  bool any = false;
  for (const Border& border : bordersOf (grid, planes, moments)) {
    const std::size_t smaller = border.smaller;
    const std::size_t larger = border.larger;
    const double squared_noise = border.squared_noise / border.cells;
    const double ratio =
        meanSquaredDistance (moments[smaller], planes.planes[larger]) / squared_noise;
    const bool would_close_a_loop =
        moments[larger].count == moments[smaller].count && larger > smaller;
    if (ratio >= best[smaller] || would_close_a_loop)
      continue;
    best[smaller] = ratio;
    goes_into[smaller] = larger;
    any = true;
  }
  if (!any)
    return false;
  const auto [merged_into, number] = closeGaps (goes_into);
  renumberPlanes (grid, merged_into, number, planes);
  return true;
}

} // namespace

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
growPlanes (const CellGrid& grid,
            const GrowingParameters& parameters,
            CellPlanes& planes)
{
  const double limit = distanceLimit (grid, parameters.distance_threshold);
  std::vector<std::size_t> border = cellsOffPlanes (planes.plane_of_cell);
  for (int round = 0; round < parameters.rounds && !border.empty(); ++round) {
    std::vector<Adoption> adoptions;
    for (const std::size_t cell : border)
      if (const auto adoption = adoptingPlane (grid, parameters, limit, planes, cell))
        adoptions.push_back (*adoption);
    for (const Adoption& adoption : adoptions) {
      planes.plane_of_cell[adoption.cell] = adoption.plane;
      planes.noise[adoption.cell] = adoption.noise;
    }
    border = cellsNextTo (grid, adoptions, planes.plane_of_cell);
  }
  refitPlanes (grid, planes);
}

void
absorbPlanes (const CellGrid& grid, double noise_factor, CellPlanes& planes)
{
  while (absorbOnce (grid, noise_factor, planes)) {
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
renumberPlanes (const CellGrid& grid,
                const Labels& merged_into,
                std::size_t number,
                CellPlanes& planes)
{
  for (std::int32_t& plane : planes.plane_of_cell)
    if (plane != no_plane)
      plane = merged_into[static_cast<std::size_t> (plane)];
  planes.planes.resize (number);
  refitPlanes (grid, planes);
}

} // namespace pcl_ops

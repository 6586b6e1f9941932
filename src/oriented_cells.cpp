// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_units.h"
#include "principal_axes.h"
#include <pcl_ops/oriented_cells.h>
#include <pcl_ops/parallel.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

namespace {

constexpr std::size_t cells_per_piece = 1024;

std::optional<CellNormal>
normalOf (const Moments& surroundings)
{
  const PrincipalAxes axes = principalAxes (surroundings.covariance());
  if (axes.normal.isZero())
    return std::nullopt;
  CellNormal normal;
  normal.plane = planeThrough (surroundings.centroid(), axes.normal);
  normal.noise = std::sqrt (axes.values[0]);
  normal.thickness = std::sqrt (axes.values[0] / axes.values[1]);
  return normal;
}

// One resolution: a grid and the plane around each of its cells.
struct Level {
  CellGrid grid;
  std::vector<std::uint32_t> cell_of_finer;
  std::vector<std::optional<CellNormal>> normals;
};

std::vector<std::optional<CellNormal>>
normalsAround (const CellGrid& grid, double min_points, unsigned threads)
{
  std::vector<std::optional<CellNormal>> normals (grid.size());
  parallelFor (
      threads, grid.size(), cells_per_piece, [&] (std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          Moments surroundings;
          for (const std::uint32_t neighbour : grid.neighbours[i])
            surroundings.addAligned (grid.moments[neighbour]);
          if (surroundings.count >= min_points)
            normals[i] = normalOf (surroundings);
        }
      });
  return normals;
}

// The flattest of the planes around a cell of a level that the finest cell lies in.
class FlattestPlane {
public:
  FlattestPlane (const Moments& cell, double noise_factor, double smallest_noise)
  : cell_ (cell), noise_factor_ (noise_factor), smallest_noise_ (smallest_noise)
  {}

  void
  consider (const std::optional<CellNormal>& candidate)
  {
    if (!candidate || candidate->thickness >= thickness())
      return;
    const double limit = noise_factor_ * std::max (candidate->noise, smallest_noise_);
    if (meanSquaredDistance (cell_, candidate->plane) < limit * limit)
      best_ = &*candidate;
  }

  double
  thickness () const
  {
    return best_ ? best_->thickness : 1.0;
  }

  const CellNormal*
  best () const
  {
    return best_;
  }

private:
  const Moments& cell_;
  double noise_factor_;
  double smallest_noise_;
  const CellNormal* best_ = nullptr;
};

std::optional<CellNormal>
normalOfCell (std::size_t cell,
              const CellGrid& finest,
              const std::vector<Level>& levels,
              const CellNormalParameters& parameters)
{
  FlattestPlane flattest (
      finest.moments[cell], parameters.noise_factor, smallestNoise (finest));
  std::size_t at = cell;
  for (const Level& level : levels) {
    at = level.cell_of_finer.empty() ? at : level.cell_of_finer[at];
    flattest.consider (level.normals[at]);
    if (flattest.thickness() < parameters.flat_enough)
      break;
    const CellGrid& grid = level.cell_of_finer.empty() ? finest : level.grid;
    for (const std::uint32_t neighbour : grid.neighbours[at])
      flattest.consider (level.normals[neighbour]);
    if (flattest.thickness() < parameters.flat_enough)
      break;
  }
  return flattest.best() ? std::optional<CellNormal> (*flattest.best()) : std::nullopt;
}

double
meanPointsPerCell (const CellGrid& grid)
{
  double points = 0.0;
  for (const Moments& cell : grid.moments)
    points += cell.count;
  return points / static_cast<double> (grid.size());
}

} // namespace

std::vector<std::optional<CellNormal>>
orientCells (const CellGrid& grid,
             const CellNormalParameters& parameters,
             unsigned threads)
{
  const double min_points =
      std::max (static_cast<double> (parameters.least_points),
                parameters.least_average_cells * meanPointsPerCell (grid));
  std::vector<Level> levels (1);
  levels.reserve (static_cast<std::size_t> (parameters.levels));
  levels[0].normals = normalsAround (grid, min_points, threads);
  for (int l = 1; l < parameters.levels; ++l) {
    CoarserGrid coarser = coarsen (l == 1 ? grid : levels.back().grid);
    Level level;
    level.grid = std::move (coarser.grid);
    level.cell_of_finer = std::move (coarser.cell_of_finer);
    level.normals = normalsAround (level.grid, min_points, threads);
    levels.push_back (std::move (level));
  }
  std::vector<std::optional<CellNormal>> normals (grid.size());
  parallelFor (
      threads, grid.size(), cells_per_piece, [&] (std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          normals[i] = normalOfCell (i, grid, levels, parameters);
      });
  return normals;
}

} // namespace pcl_ops

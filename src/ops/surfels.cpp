// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_support.h"
#include "cell_units.h"
#include "principal_axes.h"
#include <pcl_ops/oriented_cells.h>
#include <pcl_ops/parallel.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

namespace {

CellNormal
normalOf (const Moments& surroundings, const PrincipalAxes& axes)
{
  CellNormal normal;
  normal.plane = planeThrough (surroundings.centroid(), axes.normal);
  normal.noise = std::sqrt (axes.values[0]);
  normal.thickness = std::sqrt (axes.values[0] / axes.values[1]);
  return normal;
}

// One resolution: a grid and the plane around each of its cells.
struct Level {
  /** \brief Empty for the finest level, as is the next. */
  CellGrid grid;
  std::vector<std::uint32_t> cell_of_finest;
  std::vector<std::optional<CellNormal>> normals;
  /** \brief Of the normals, apart because most are looked at for this only; 1 where
   * there is none. */
  std::vector<double> thickness;
  /** \brief For each cell the one around it, or itself, with the least thickness. */
  std::vector<std::uint32_t> flattest_around;

  const CellGrid&
  gridOr (const CellGrid& finest) const
  {
    return cell_of_finest.empty() ? finest : grid;
  }

  std::size_t
  cellHolding (std::size_t finest_cell) const
  {
    return cell_of_finest.empty() ? finest_cell : cell_of_finest[finest_cell];
  }
};

Moments
momentsAround (const CellGrid& grid, std::size_t cell)
{
  Moments surroundings;
  for (const std::uint32_t neighbour : grid.neighbours[cell])
    surroundings.addAligned (grid.moments[neighbour]);
  return surroundings;
}

// The normals of a range of cells.
void
findNormals (const CellGrid& grid,
             double min_points,
             std::size_t begin,
             std::size_t end,
             Level& level)
{
  std::vector<std::size_t> cells;
  std::vector<Moments> surroundings;
  std::vector<Eigen::Matrix3d> covariances;
  cells.reserve (end - begin);
  surroundings.reserve (end - begin);
  covariances.reserve (end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    const Moments moments = momentsAround (grid, i);
    if (moments.count < min_points)
      continue;
    cells.push_back (i);
    surroundings.push_back (moments);
    covariances.push_back (moments.covariance());
  }
  std::vector<PrincipalAxes> axes (cells.size());
  principalAxes (covariances.data(), cells.size(), axes.data());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (axes[i].normal.isZero())
      continue;
    const CellNormal normal = normalOf (surroundings[i], axes[i]);
    level.normals[cells[i]] = normal;
    level.thickness[cells[i]] = normal.thickness;
  }
}

void
findNormals (const CellGrid& grid, double min_points, unsigned threads, Level& level)
{
  // So few that what is noted of them stays in the processor's first cache.
  constexpr std::size_t cells_at_once = 128;
  level.normals.resize (grid.size());
  level.thickness.resize (grid.size(), 1.0);
  parallelFor (
      threads, grid.size(), cells_at_once, [&] (std::size_t begin, std::size_t end) {
        findNormals (grid, min_points, begin, end, level);
      });
  level.flattest_around.resize (grid.size());
  forCells (grid, threads, [&] (std::size_t i) {
    level.flattest_around[i] =
        *std::min_element (grid.neighbours[i].begin(),
                           grid.neighbours[i].end(),
                           [&level] (std::uint32_t a, std::uint32_t b) {
                             return level.thickness[a] < level.thickness[b];
                           });
  });
}

// The flattest of the planes around a cell of a level that the finest cell lies in.
class FlattestPlane {
public:
  FlattestPlane (const Moments& cell, double noise_factor, double smallest_noise)
  : cell_ (cell), noise_factor_ (noise_factor), smallest_noise_ (smallest_noise)
  {}

  /** \brief Considers the planes around a cell of a level. The flattest may mostly
   * serve, and spares a look at the others. */
  void
  considerAll (const Level& level, std::size_t at, const CellGrid& finest)
  {
    const std::uint32_t flattest = level.flattest_around[at];
    if (level.thickness[flattest] >= thickness_)
      return;
    consider (level, flattest);
    if (best_ == &*level.normals[flattest])
      return;
    for (const std::uint32_t candidate : level.gridOr (finest).neighbours[at])
      consider (level, candidate);
  }

  void
  consider (const Level& level, std::size_t candidate)
  {
    if (level.thickness[candidate] >= thickness_)
      return;
    const CellNormal& normal = *level.normals[candidate];
    const double limit = noise_factor_ * std::max (normal.noise, smallest_noise_);
    if (meanSquaredDistance (cell_, normal.plane) >= limit * limit)
      return;
    best_ = &normal;
    thickness_ = normal.thickness;
  }

  double
  thickness () const
  {
    return thickness_;
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
  double thickness_ = 1.0;
};

std::optional<CellNormal>
normalOfCell (std::size_t cell,
              const CellGrid& finest,
              const std::vector<Level>& levels,
              const CellNormalParameters& parameters)
{
  FlattestPlane plane (
      finest.moments[cell], parameters.noise_factor, smallestNoise (finest));
  for (const Level& level : levels) {
    const std::size_t at = level.cellHolding (cell);
    if (level.thickness[at] < parameters.flat_enough)
      plane.consider (level, at);
    // Where nothing around is flat enough, a coarser level is likely to have better.
    if (plane.thickness() >= parameters.flat_enough &&
        level.thickness[level.flattest_around[at]] < parameters.flat_enough)
      plane.considerAll (level, at, finest);
    if (plane.thickness() < parameters.flat_enough)
      return *plane.best();
  }
  for (auto level = levels.rbegin(); level != levels.rend(); ++level)
    plane.considerAll (*level, level->cellHolding (cell), finest);
  return plane.best() ? std::optional<CellNormal> (*plane.best()) : std::nullopt;
}

double
meanPointsPerCell (const CellGrid& grid)
{
  double points = 0.0;
  for (const Moments& cell : grid.moments)
    points += cell.count;
  return points / static_cast<double> (grid.size());
}

// The level after the last one.
Level
coarserLevel (const CellGrid& finest, const Level& last, unsigned threads)
{
  CoarserGrid coarser = coarsen (last.gridOr (finest), threads);
  Level level;
  level.grid = std::move (coarser.grid);
  level.cell_of_finest.resize (finest.size());
  for (std::size_t i = 0; i < finest.size(); ++i)
    level.cell_of_finest[i] = coarser.cell_of_finer[last.cellHolding (i)];
  return level;
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
  std::vector<Level> levels;
  for (int l = 0; l < parameters.levels; ++l) {
    levels.push_back (l == 0 ? Level() : coarserLevel (grid, levels.back(), threads));
    findNormals (levels.back().gridOr (grid), min_points, threads, levels.back());
  }
  std::vector<std::optional<CellNormal>> normals (grid.size());
  forCells (grid, threads, [&] (std::size_t i) {
    normals[i] = normalOfCell (i, grid, levels, parameters);
  });
  return normals;
}

} // namespace pcl_ops

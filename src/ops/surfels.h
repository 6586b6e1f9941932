// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cell_grid.h>
#include <pcl_ops/plane.h>

#include <optional>
#include <vector>

namespace pcl_ops {

/** \brief How the cells of a grid get their normals. */
struct CellNormalParameters {
  /** \brief Grids to choose a neighbourhood from, each of twice the cell size of the
   * one before. */
  int levels = 3;
  /** \brief A normal comes from at least as many points as this many cells hold on
   * average: where points are sparse, as they are far from a camera and noisy there,
   * the neighbourhoods are larger. */
  double least_average_cells = 8.0;
  /** \brief And from at least this many points: k. */
  int least_points = 30;
  /** \brief Thickness of a neighbourhood over its width up to which it is flat enough
   * to look no further. */
  double flat_enough = 0.2;
  /** \brief A cell may take the normal of a neighbouring cell if its points' rms
   * distance to that plane is below this many times the noise there. */
  double noise_factor = 1.5;
};

/** \brief The plane of a cell's surroundings. */
struct CellNormal {
  Plane plane;
  /** \brief Rms distance of the surrounding points to the plane [m]: the noise, where
   * the surroundings are flat. */
  double noise = 0.0;
  /** \brief The noise over the spread in the plane's narrow direction: 0 for an exact
   * plane, 1 for a ball. */
  double thickness = 1.0;
};

/** \brief The oriented samples of a grid: a normal for each cell, or nothing.
 *
 * The neighbourhood is the 3 x 3 x 3 cells around at the finest of several resolutions
 * that is flat and holds enough points: noise that grows with distance gets the larger
 * neighbourhoods it needs. Next to an edge, where the cell's own neighbourhood bends,
 * the flattest one of those around its neighbours that the cell lies in serves instead
 * (the idea of Kuwahara's edge-preserving filter). */
std::vector<std::optional<CellNormal>>
orientCells (const CellGrid& grid,
             const CellNormalParameters& parameters,
             unsigned threads);

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/curve_points.h"

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief Levels of the octree of cells: a cell of level l is 2^l finest cells wide. */
constexpr int top_level = 20;

/** \brief How the points of one cell of the octree lie about their plane. */
struct CellScatter {
  /** \brief Number of its first point, and how many there are. */
  std::uint32_t begin = 0, count = 0;
  int level = 0;
  /** \brief Whether the points are spread over the cell in two directions: only then do
   * they tell a noise. */
  bool is_wide = false;
  /** \brief RMS distance of the points to their plane, of as many as are free [m]. */
  float noise = 0.0f;
  /** \brief RMS distance of the centroids of its quarters along the plane to that
   * plane, less what independent noise gives means of so many points [m]. Zero for
   * white noise, however large; the noise itself where neighboring points err alike, as
   * those of a smoothed depth image do. */
  float unevenness = 0.0f;
};

/** \brief The scatter of all cells with enough points for a plane, smaller cells before
 * the one that holds them. Cells up to level 10 are in the order of the points, as
 * \ref UnevenNoise needs those of its regions to be; larger ones are last. */
std::vector<CellScatter>
scatterOfCells (const CurvePoints& points, unsigned threads);

/** \brief How dense points are: the logarithm (base 2) of their number on the square of
 * a finest cell, of a surface that has \p count points in a cell of a level. */
double
densityOf (double count, int level);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"
#include "voxels/morton_code.h"
#include <pcl_ops/plane.h>

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief The different points of a cloud along a space-filling curve: the points of a
 * cell of an octree follow each other. Equal points count once: drivers write missing
 * readings as zeros, and data sets draw points more than once. */
struct CurvePoints : Coordinates {
  /** \brief Of the finest cell that holds each point; ascending. */
  std::vector<MortonCode> code;
  /** \brief Which of these points each point of the cloud is. */
  Indices of_input;
  /** \brief Edge of the finest cells [m]. */
  double cell = 0.0;
};

/** \brief Sorts points into the order of the curve. Points that share a finest cell are
 * sorted by their coordinates: the order of the cloud does not matter.
 * \param[in] positions finite points; those beyond 2^18 cells from zero share the
 * outermost cells
 * \param[in] cell edge of the finest cells [m] */
CurvePoints
sortAlongCurve (const Coordinates& positions, double cell, unsigned threads);

/** \brief The end of the run of points, from \p begin on, that share a cell of edge
 * 2^level finest cells. */
std::uint32_t
endOfCell (const std::vector<MortonCode>& codes,
           std::uint32_t begin,
           std::uint32_t end,
           int level);

/** \brief Labels of the points of a cloud, in the order of the curve. */
Labels
alongCurve (const CurvePoints& points, const Labels& labels);

} // namespace pcl_ops::internal

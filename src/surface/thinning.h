// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

namespace pcl_ops {

/** \brief Points, each standing for some. */
struct WeightedPoints {
  PlanarPoints points;
  std::vector<std::size_t> weights;
};

/** \brief All points near the rim, and one for each square cell that has points in all
 * cells around it. \param[in] cell side of a cell [m] */
WeightedPoints
thinInside (const PlanarPoints& points, double cell);

} // namespace pcl_ops

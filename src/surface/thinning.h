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

/** \brief All points near the rim, and one for each square voxel that has points in all
 * voxels around it. \param[in] voxel side of a voxel [m] */
WeightedPoints
thinInside (const PlanarPoints& points, double voxel);

} // namespace pcl_ops

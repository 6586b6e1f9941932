// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/voxel_grid.h"
#include <pcl_ops/plane.h>

namespace pcl_ops::internal {

/** \brief How far a patch bends away from its plane. */
struct Bending {
  /** \brief Adjusted R^2 of the terms u^2, u v and v^2: the share of the residual
   * variance of a flat fit that they explain. At most 1; below 0 if they explain less
   * than chance does. */
  double explained_share = 0.0;
  /** \brief Largest absolute height that these terms have on the ellipse whose half
   * axes are half the length and half the width of the patch [m]. */
  double amplitude = 0.0;
  /** \brief Distance from the center to the edge of that ellipse in the direction of
   * the largest bend [m]. */
  double half_extent = 0.0;
};

/** \brief Fits 1, u, v, u^2, u v and v^2, with u and v along the plane, to the heights
 * of the centroids of voxels over it by least squares. The weight of a voxel is its
 * number of points.
 * \param[in] voxels indices of the voxels of the patch
 * \param[in] fit plane and centroid from which heights, u and v are measured; it may be
 * the fit of a part of these voxels
 * \return all zero for fewer than eight voxels */
Bending
bendingOf (const VoxelGrid& grid, const Indices& voxels, const PlaneFit& fit);

/** \brief Whether a patch is part of a curved surface: second-order terms explain more
 * than 0.4 of its residual variance, and its amplitude is more than 0.01 of its half
 * extent. Below 0.01, errors of a sensor can bend a wall as much. */
bool
isCurved (const Bending& bending);

} // namespace pcl_ops::internal

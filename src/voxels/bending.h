// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/voxel_grid.h"
#include <pcl_ops/plane.h>

namespace pcl_ops::internal {

/** \brief How far a patch bends away from its plane. */
struct Bending {
  /** \brief Adjusted R^2 of the second-order terms: the share of the residual variance
   * of a flat fit that they explain, at most 1. */
  double explained = 0.0;
  /** \brief Largest height that the second-order terms have on the ellipse whose half
   * axes are half the length and half the width of the patch [m]. */
  double amplitude = 0.0;
  /** \brief Half the extent of the patch in the direction of its largest bend [m]. */
  double half_extent = 0.0;
};

/** \brief Fits 1, u, v, u^2, u v and v^2, with u and v along the plane, to the mean
 * heights of voxels over it by least squares. A voxel weighs as much as its points.
 * \param[in] voxels indices of the voxels of the patch
 * \param[in] fit plane and centroid from which heights, u and v are measured; it may be
 * the fit of a part of these voxels
 * \return all zero for fewer than eight voxels */
Bending
bendingOf (const VoxelGrid& grid, const Indices& voxels, const PlaneFit& fit);

/** \brief Whether a patch is part of a curved surface: second-order terms explain its
 * unevenness, and amplitude over half extent is more than a sensor bends a wall by. */
bool
isCurved (const Bending& bending);

} // namespace pcl_ops::internal

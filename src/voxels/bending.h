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
  /** \brief Largest second-order height on the ellipse of half extents [m]. */
  double amplitude = 0.0;
  /** \brief Half the extent of the patch in the direction of its largest bend [m]. */
  double half_extent = 0.0;
};

/** \brief Fits 1, u, v, u^2, u v and v^2, with u and v along the plane, to the mean
 * heights of voxels over it by least squares. A voxel weighs as much as its points.
 * \param[in] voxels indices of the voxels of the patch
 * \return all zero for fewer than eight voxels */
Bending
bendingOf (const VoxelGrid& grid, const Indices& voxels, const PlaneFit& fit);

/** \brief Whether a patch is part of a curved surface: second-order terms explain its
 * unevenness, and amplitude over half extent is more than a sensor bends a wall by. */
bool
isCurved (const Bending& bending);

} // namespace pcl_ops::internal

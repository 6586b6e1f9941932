// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/voxel_grid.h"
#include <pcl_ops/plane.h>

namespace pcl_ops::internal {

/** \brief How far a patch bends away from its plane. */
struct Bending {
  /** \brief Share of the unevenness that second order terms explain, adjusted for their
   * number (R^2), up to 1. */
  double explained = 0.0;
  /** \brief Largest deviation from the plane by the second order terms [m]. */
  double amplitude = 0.0;
  /** \brief Half the extent of the patch in the direction it bends in [m]. */
  double half_extent = 0.0;
};

/** \brief Least squares of the mean heights of voxels above a plane by 1, u, v, u^2, u
 * v and v^2, u and v along the plane, each voxel weighing as much as its points.
 * \param[in] voxels those of the patch; a bending of 0 for fewer than eight */
Bending
bendingOf (const VoxelGrid& grid, const Indices& voxels, const PlaneFit& fit);

/** \brief Whether a patch is part of a curved surface: the bending explains it, and its
 * slope (amplitude over half extent) is more than a sensor bends a wall by. */
bool
isCurved (const Bending& bending);

} // namespace pcl_ops::internal

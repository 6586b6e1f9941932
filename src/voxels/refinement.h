// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/bounded_planes.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief The part of a cloud that no plane explains in coarse voxels, in voxels of
 * half their edge. */
struct Refinement {
  /** \brief Whether a coarse voxel's points are looked at here. */
  std::vector<char> is_refined;
  VoxelGrid grid;
  /** \brief The coarse planes with the voxels here that they explain. */
  BoundedPlanes planes;
};

/** \brief Divides coarse voxels of 8 points and more that have no plane, and those next
 * to them, into voxels of half the edge. A voxel there keeps the plane of the coarse
 * one that holds it if its points lie on it.
 * \param[in] planes those found in coarse voxels, with their noise */
Refinement
refine (const VoxelLevels& voxels, const BoundedPlanes& planes, unsigned threads);

} // namespace pcl_ops::internal

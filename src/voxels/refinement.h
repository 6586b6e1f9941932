// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/bounded_planes.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief Voxels of half the edge, for the part of a cloud that no plane explains in
 * coarse voxels. */
struct Refinement {
  /** \brief For each coarse voxel, whether its points are in \ref grid. */
  std::vector<char> is_refined;
  VoxelGrid grid;
  /** \brief The coarse planes, with the voxels of \ref grid that they explain. */
  BoundedPlanes planes;
};

/** \brief Divides coarse voxels without a plane that have 8 points or more, and the
 * neighbors of these voxels, into voxels of half the edge. A finer voxel keeps the
 * plane of the coarse voxel that contains it if the rms distance of its points to that
 * plane is below max_voxel_rms_in_noises (plane_growing.h) times the plane's noise.
 * \param[in] voxels both levels; \ref connect was called for the coarse one
 * \param[in] planes found in the coarse voxels, with their noise */
Refinement
refine (const VoxelLevels& voxels, const BoundedPlanes& planes, unsigned threads);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief Keeps coplanar surfaces apart: connected parts of a plane become planes of
 * their own where the sensor looked through between them; where something stood in
 * front they stay one.
 * \param[in] grid the voxels
 * \param[in] viewpoint of the sensor in the frame of the grid
 * \param[in] least_voxels parts of fewer voxels stay with their plane
 * \param[in,out] planes each gives its parts away; new ones are added */
void
separateSurfaces (const VoxelGrid& grid,
                  const Eigen::Vector3d& viewpoint,
                  std::size_t least_voxels,
                  BoundedPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/bounded_planes.h"

#include <optional>

namespace pcl_ops::internal {

/** \brief Lets planes grow into voxels without a plane that touch their support, as
 * long as the rms distance of the voxel's points is below a multiple of the noise next
 * to it. \param[in] grid the voxels \param[in] distance_threshold theta_h: largest rms
 * distance [m]; none: two voxels \param[in] threads number of threads; 0: all. The
 * result does not depend on it \param[in,out] planes refitted to their voxels */
void
growPlanes (const VoxelGrid& grid,
            std::optional<double> distance_threshold,
            unsigned threads,
            BoundedPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief Finds planes to absorb into a larger plane that they touch: the rms distance
 * of their points to it is below \p noise_factor times the noise of both planes.
 * \return for each plane the plane that finally absorbs it; itself if none does */
Labels
absorbPlanes (const VoxelGrid& grid, double noise_factor, const BoundedPlanes& planes);

} // namespace pcl_ops::internal

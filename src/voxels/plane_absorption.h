// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/bounded_planes.h"

namespace pcl_ops::internal {

/** \brief Finds planes to absorb into a larger plane that they touch: the rms distance
 * of their points to the larger plane is below \p noise_factor times the rms distance
 * that its own points have. The latter is at least the noise of the larger plane, and
 * counts as at most \ref other_noise times that of the smaller one.
 * \param[in] planes with their noise
 * \return for each plane the plane that finally absorbs it; itself if none does */
Labels
absorbPlanes (const VoxelGrid& grid, double noise_factor, const BoundedPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/bounded_planes.h"
#include "voxels/surfels.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Finds connected planes by region growing. Each surfel is a plane hypothesis,
 * as a point with its normal is in one-point RANSAC, but no draw is needed: the
 * flattest surfel that is on no plane yet is the next seed. Its plane grows over
 * neighboring voxels whose points lie on it, and is refitted several times. Curved
 * patches are no planes.
 * \param[in] surfels one for each voxel, or nothing
 * \param[in] max_thickness surfels of this thickness (\ref Surfel::thickness) or more
 * are on no plane
 * \param[in] parameters min_samples is the smallest number of voxels of a plane
 * \param[in,out] planes found before, whose voxels are left out; new planes are
 * appended, those of the flattest seeds first, without their noise */
void
extractSurfelPlanes (const VoxelGrid& grid,
                     const std::vector<std::optional<Surfel>>& surfels,
                     const OrientedPointSamplingParameters& parameters,
                     double max_thickness,
                     BoundedPlanes& planes);

} // namespace pcl_ops::internal

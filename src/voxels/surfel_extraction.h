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
 * flattest surfel on no plane yet is the seed. Its plane spreads to neighboring voxels
 * whose points lie on it, and is refitted on the way. Only neighbors are tested, so
 * that the cost does not depend on the number of planes. Curved patches are no planes.
 * \param[in] max_thickness surfels thicker than this support no plane
 * \param[in] parameters min_samples is the fewest voxels of a plane
 * \param[in,out] planes found before, whose voxels are left out; new planes are
 * appended, those of the flattest seeds first, without their noise */
void
extractSurfelPlanes (const VoxelGrid& grid,
                     const std::vector<std::optional<Surfel>>& surfels,
                     const OrientedPointSamplingParameters& parameters,
                     double max_thickness,
                     BoundedPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/bounded_planes.h"
#include "voxels/surfels.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Finds planes that are connected: each surfel is a hypothesis of its own, as a
 * point with its normal is in one-point RANSAC, but no draw is needed. The flattest
 * surfel that no plane has yet spreads to its neighbors while all their points lie on
 * its plane, which is refitted on the way; only neighbors are asked, so that the cost
 * does not depend on the number of planes. What is curved is no plane.
 * \param[in] max_thickness surfels thicker than this support no plane
 * \param[in,out] planes those found before, whose voxels are not asked; new ones are
 * added, those of the flattest surfels first */
void
extractSurfelPlanes (const VoxelGrid& grid,
                     const std::vector<std::optional<Surfel>>& surfels,
                     const OrientedPointSamplingParameters& parameters,
                     double max_thickness,
                     BoundedPlanes& planes);

} // namespace pcl_ops::internal

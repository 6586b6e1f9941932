// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/bounded_planes.h"
#include "ops/surfels.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief One-point hypotheses on the surfels of a grid. */
struct SurfelExtractionParameters {
  /** \brief Largest rms distance of a voxel's points to its plane in units of the noise
   * around it. */
  double noise_factor = 2.0;
  /** \brief Largest angle between a surfel's normal and the plane's [rad]. */
  double angle_threshold = 0.0;
  /** \brief Surfels thicker than this support no plane. */
  double max_thickness = 0.0;
  /** \brief theta_N: a plane needs at least this many connected surfels. */
  std::size_t min_inliers = 20;
};

/** \brief Finds planes that are connected: each surfel is a hypothesis of its own, as a
 * point with its normal is in one-point RANSAC, but no draw is needed. The flattest
 * surfel that no plane has yet spreads to its neighbors while all their points lie on
 * its plane, which is refitted on the way; only neighbors are asked, so that the cost
 * does not depend on the number of planes. What is curved is no plane.
 * \param[in] grid the voxels
 * \param[in] surfels of each voxel, or nothing
 * \param[in] parameters thresholds
 * \param[in,out] planes those found before, whose voxels are not asked; new ones are
 * added, those of the flattest surfels first */
void
extractSurfelPlanes (const VoxelGrid& grid,
                     const std::vector<std::optional<Surfel>>& surfels,
                     const SurfelExtractionParameters& parameters,
                     BoundedPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/random.h"
#include "bounded/bounded_planes.h"
#include "ops/surfels.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief One-point RANSAC on the surfels of a grid. */
struct SurfelRansacParameters {
  /** \brief Largest distance of a surfel to its plane [m]. */
  double distance_limit = 0.0;
  /** \brief The same in units of the noise measured around the surfel. */
  double noise_factor = 3.0;
  /** \brief Largest angle between a surfel's normal and the plane's [rad]. */
  double angle_threshold = 0.0;
  /** \brief Largest rms angle between the normals of a plane's surfels and its own
   * [rad] (SurfelParameters::largest_normal_spread). */
  double largest_normal_spread = 0.0;
  /** \brief Surfels thicker than this support no plane. */
  double largest_thickness = 0.0;
  /** \brief theta_N: a plane needs at least this many connected surfels. */
  std::size_t min_inliers = 20;
  /** \brief p: probability that one of the draws is an inlier of the largest plane. */
  double probability = 0.99;
};

/** \brief Finds planes among the surfels that have none by one-point RANSAC: largest
 * planes first, surfels weigh as much as their points, normals are compared too; refits
 * the winner while its support grows, and keeps the connected parts of its support that
 * are large enough.
 * \param[in] grid the voxels
 * \param[in] surfels of each voxel, or nothing
 * \param[in] parameters thresholds and the probability of success
 * \param[in,out] generator draws the hypotheses
 * \param[in,out] planes those found before, empty at first; new ones are added */
void
extractSurfelPlanes (const VoxelGrid& grid,
                     const std::vector<std::optional<Surfel>>& surfels,
                     const SurfelRansacParameters& parameters,
                     RandomGenerator& generator,
                     BoundedPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_surfels.h"

#include <vector>

namespace pcl_ops::internal {

struct LeafSpreadParameters {
  /** \brief Surfels thicker than this support no plane. */
  double max_thickness = 0.0;
  /** \brief Leaves a plane needs. */
  double min_leaves = 0.0;
  /** \brief Largest rms distance of a leaf's points, in units of the noise there. */
  double noise_factor = 0.0;
  /** \brief Largest angle of a surfel to its plane [rad]. */
  double max_angle = 0.0;
};

/** \brief Finds planes that are connected: each surfel is a hypothesis of its own, as a
 * point with its normal is in one-point RANSAC, but no draw is needed. The flattest
 * surfel that no plane has yet spreads to its neighbors while all their points lie on
 * its plane, which is refitted on the way. What is curved is no plane.
 * \param[in,out] planes those found before, whose leaves are not asked */
void
spreadPlanes (const LeafCloud& cloud,
              const std::vector<LeafSurfel>& surfels,
              const LeafSpreadParameters& parameters,
              LeafPlanes& planes);

} // namespace pcl_ops::internal

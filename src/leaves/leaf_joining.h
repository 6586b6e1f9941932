// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"

namespace pcl_ops::internal {

struct JoiningParameters {
  /** \brief Largest distance of planes that touch, in units of their noise. */
  double max_distance = 0.0;
  /** \brief Whether planes that do not touch may be one, their largest angle [rad], and
   * their largest distance in units of their noise. */
  bool joins_over_gaps = true;
  double max_angle_over_gaps = 0.0;
  double max_distance_over_gaps = 0.0;
};

/** \brief Makes one plane of those that are one: what noise divided, what a bent
 * surface is in pieces, what others enclose, what goes on behind a gap. Smaller planes
 * go into larger ones, over all contacts, until none does. Planes are numbered anew
 * only by \ref LeafPlanes::plane_of_leaf: those that went into others have no leaves.
 */
void
joinPlanes (const LeafCloud& cloud,
            const JoiningParameters& parameters,
            unsigned threads,
            LeafPlanes& planes);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"

namespace pcl_ops::internal {

/** \brief How far some leaves bend away from their plane: least squares of the heights
 * of their centroids by 1, u, v, u^2, u v and v^2, u and v along the plane. */
struct LeafBending {
  /** \brief Share of the unevenness that second order terms explain, adjusted for their
   * number (R^2), up to 1. */
  double explained = 0.0;
  /** \brief Largest deviation from the plane by the second order terms [m]. */
  double amplitude = 0.0;
  /** \brief Half the extent in the direction of that bend [m]. */
  double half_extent = 1.0;
  /** \brief RMS distance of the points that the bend leaves [m]. */
  double left = 0.0;
  /** \brief How many leaves were looked at: of a large plane a sample. */
  std::size_t leaves = 0;
};

/** \return no bending for fewer than eight leaves */
LeafBending
bendingOfLeaves (const LeafCloud& cloud, const Indices& leaves, const Plane& plane);

/** \brief Whether the leaves are part of a curved surface: the bending explains it, and
 * its slope (amplitude over half extent) is more than a sensor bends a wall by. */
bool
isCurved (const LeafBending& bending);

} // namespace pcl_ops::internal

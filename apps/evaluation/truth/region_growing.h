// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/labels/labels.h>

namespace pcl_ops::evaluation {

/** \brief How true planes are made for clouds without labels (paper section IV-A). */
struct RegionGrowingParameters {
  /** \brief Neighbors of a point its normal comes from and its region may grow to. The
   * paper does not say; on raw depth 30 leave many points without a plane. */
  int neighbors = 100;
  /** \brief Largest distance of a point to its region's plane [m]. */
  double distance_threshold = 0.05;
  /** \brief Largest angle between the normals of neighbors in a region [rad]. */
  double angle_threshold = paper_angle;
  /** \brief Smaller regions are on no plane. */
  std::size_t min_points = 50;
};

/** \brief Planes by region growing from the flattest points on: a neighbor of a point
 * joins its region if it is near the region's plane and both normals agree.
 * \param[in] cloud finite points
 * \param[in] parameters thresholds and neighborhood
 * \return labels 1 .. P by falling size */
PlaneLabels
growRegions (const XyzCloud& cloud, const RegionGrowingParameters& parameters);

} // namespace pcl_ops::evaluation

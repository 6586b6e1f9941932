// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <optional>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief A plane as one cloud of a sequence shows it, in the common frame. */
struct PlaneSighting {
  Eigen::Vector3d centroid, normal;
  PlaneCovariance covariance;
};

/** \param[in] pose from the cloud's frame to the common one
 * \return nothing for planes without a covariance */
std::optional<PlaneSighting>
sightingOf (const apps::XyzCloud& cloud,
            const PlaneSegment& plane,
            const Eigen::Isometry3d& pose);

/** \brief How far two sightings of one surface differ, over what their covariances
 * allow: absolute values with a median of 0.67 and 90 % below 1.64 if covariances are
 * right and errors have a normal distribution. */
struct NormalizedErrors {
  /** \brief Of the height of the second's centroid over the first. */
  std::vector<double> offsets;
  /** \brief Of the slopes along both axes of the first. */
  std::vector<double> tilts;

  void
  add (const PlaneSighting& first, const PlaneSighting& second);
};

} // namespace pcl_ops::evaluation

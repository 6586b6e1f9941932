// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_ops::apps {

/** \brief Two planes that may be one surface. */
struct OverlappingPlanes {
  /** \brief Indices of the plane with more inliers and of the other one in the list of
   * planes. */
  std::size_t larger, smaller;
  /** \brief The distance of the centroid of one plane to the other plane [m]; of both
   * such distances the larger one. */
  double distance;
};

/** \brief Finds two planes that may be one surface:
 * - the angle between them is 7 degrees at most;
 * - OverlappingPlanes::distance is at most 3 times the larger rms of both;
 * - the smaller plane has at least 2 % of the inliers of the larger one;
 * - their convex outlines overlap, or the gap between them is at most 4 times the point
 *   spacing of the smaller plane.
 * \param[in] planes by falling number of inliers, in the frame of the cloud
 * \return of several such pairs the one whose smaller plane has most inliers; nothing
 * if there is none */
std::optional<OverlappingPlanes>
findOverlapping (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes);

} // namespace pcl_ops::apps

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
  /** \brief Indices in the list of planes. */
  std::size_t larger, smaller;
  /** \brief The larger one of the distances of each centroid to the other plane [m]. */
  double distance;
};

/** \brief Finds two planes that may be one surface. They are parallel within 7 degrees
 * and no farther apart than 3 times the larger rms distance. The smaller plane has at
 * least 2 % of the inliers of the larger one. Their convex outlines overlap, or the gap
 * is at most 4 times the point spacing of the smaller plane. Of several pairs it
 * returns the one whose smaller plane has most inliers.
 * \param[in] planes by falling size, in the frame of the cloud */
std::optional<OverlappingPlanes>
findOverlapping (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_ops::apps {

/** \brief Two planes that may be one surface, by their positions in a list. */
struct OverlappingPlanes {
  std::size_t larger, smaller;
  /** \brief The larger of the two distances from a centroid to the other plane [m]. */
  double distance;
};

/** \brief Finds two planes that may be one surface: parallel within 7 degrees, no
 * farther apart than three times the larger rms, the smaller with 2 % of the points of
 * the larger or more, with outlines that overlap or are a few spacings of their points
 * apart. Of several such pairs it takes the one whose smaller plane has most points.
 * \param[in] planes by falling size */
std::optional<OverlappingPlanes>
findOverlapping (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes);

} // namespace pcl_ops::apps

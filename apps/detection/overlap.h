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
  /** \brief The larger one of both distances from a centroid to the other plane [m]. */
  double distance;
};

/** \brief Of planes that are parallel within 7 degrees, not farther apart than three
 * times the noise of the noisier one, and whose outlines overlap or are a few spacings
 * of their points apart: the two of which the smaller one has most points.
 * \param[in] planes by falling size */
std::optional<OverlappingPlanes>
findOverlapping (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distances.h"

#include <io/shifted_cloud.h>

#include <limits>

namespace pcl_ops::apps {

std::vector<float>
distancesOf (const FileCloud& cloud, const std::vector<PlaneSegment>& planes)
{
  const CoordinateReader place (cloud);
  std::vector<float> distances (cloud.size(), std::numeric_limits<float>::quiet_NaN());
  for (const PlaneSegment& plane : planes)
    for (const pcl::index_t inlier : plane.inliers) {
      const auto i = static_cast<std::size_t> (inlier);
      // From the centroid: an equation's offset has few digits left far from zero.
      distances[i] = static_cast<float> (plane.normal.dot (place (i) - plane.centroid));
    }
  return distances;
}

} // namespace pcl_ops::apps

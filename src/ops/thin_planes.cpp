// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/thin_planes.h"

#include "leaves/plane_evidence.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

namespace {

// How far the points of each plane may be from it [m].
std::vector<double>
distancesOf (const LabelledPlanes& found, const ThinPlaneLimits& limits)
{
  std::vector<double> distances (found.planes.fits.size(), limits.distance);
  for (std::size_t plane = 0; plane < distances.size(); ++plane) {
    const double thin = limits.noises * found.noises.at (plane).value_or (0.0);
    if (thin > 0.0 && found.planes.fits[plane].variances[0] > thin * thin)
      distances[plane] = std::min (distances[plane], thin);
  }
  return distances;
}

// Labels without the points that are too far away, and without planes that have too
// few then.
Labels
nearLabels (const Points& points,
            const LabelledPlanes& found,
            const std::vector<double>& distances)
{
  Labels labels = found.labels;
  std::vector<std::size_t> counts (distances.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::int32_t& plane = labels[i];
    if (plane == no_plane)
      continue;
    const Plane& own = found.planes.fits[plane].plane;
    if (std::abs (own.distance (points[i])) <= distances[plane])
      ++counts[plane];
    else
      plane = no_plane;
  }
  for (std::int32_t& plane : labels)
    if (plane != no_plane && counts[plane] < min_points_of_plane)
      plane = no_plane;
  return labels;
}

} // namespace

LabelledPlanes
keepThin (const Points& points,
          const ThinPlaneLimits& limits,
          unsigned threads,
          LabelledPlanes found)
{
  const std::vector<double> distances = distancesOf (found, limits);
  Labels labels = nearLabels (points, found, distances);
  if (labels == found.labels)
    return found;
  std::vector<Moments> moments =
      momentsOfLabels (points, labels, distances.size(), threads);
  return relabelled (found, {std::move (labels), std::move (moments)}, threads);
}

} // namespace pcl_ops::internal

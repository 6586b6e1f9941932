// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/thin_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

namespace {

// How far points of planes that are too thick may be from them [m].
std::vector<double>
limitsOf (const LabelledPlanes& found, double max_noises)
{
  std::vector<double> limits (found.planes.fits.size(),
                              std::numeric_limits<double>::infinity());
  for (std::size_t plane = 0; plane < limits.size(); ++plane) {
    const double limit = max_noises * found.noises[plane].value_or (0.0);
    if (limit > 0.0 && found.planes.fits[plane].variances[0] > limit * limit)
      limits[plane] = limit;
  }
  return limits;
}

} // namespace

LabelledPlanes
keepThin (const Points& points,
          double max_noises,
          unsigned threads,
          LabelledPlanes found)
{
  const std::vector<double> limits = limitsOf (found, max_noises);
  if (std::none_of (limits.begin(), limits.end(), [] (double limit) {
        return std::isfinite (limit);
      }))
    return found;
  AssignedPoints assigned{found.labels, {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::int32_t& plane = assigned.labels[i];
    if (plane == no_plane)
      continue;
    const Plane& own = found.planes.fits[plane].plane;
    if (std::abs (own.distance (points[i])) > limits[plane])
      plane = no_plane;
  }
  assigned.moments = momentsOfLabels (points, assigned.labels, limits.size(), threads);
  return relabelled (found, std::move (assigned), threads);
}

} // namespace pcl_ops::internal

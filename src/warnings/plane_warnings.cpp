// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings/plane_warnings.h"

#include "warnings/constants.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

/** \brief How far the points of a plane would be apart, were they even [m]: uniform
 * points on a rectangle of sides a, b have variances a^2 / 12 and b^2 / 12. */
double
spacingOn (const PlaneSegment& plane)
{
  const std::optional<PlaneFit> fit = fitPlane (plane.moments);
  if (!fit)
    return 0.0;
  const double area = 12.0 * std::sqrt (fit->variances[1] * fit->variances[2]);
  return std::sqrt (area / plane.moments.count);
}

bool
isThickPlane (const PlaneSegment& plane)
{
  const double rms = plane.rms();
  return plane.noise && rms > warning_constants.thick_noises * *plane.noise &&
         rms > warning_constants.min_rms_of_spacing * spacingOn (plane);
}

} // namespace

std::optional<ResultWarning>
warnOfThickPlanes (const std::vector<PlaneSegment>& planes, const ParameterText& text)
{
  double on_planes = 0.0;
  double on_thick = 0.0;
  const PlaneSegment* largest = nullptr;
  for (const PlaneSegment& plane : planes) {
    on_planes += plane.moments.count;
    if (!isThickPlane (plane))
      continue;
    on_thick += plane.moments.count;
    if (!largest || plane.moments.count > largest->moments.count)
      largest = &plane;
  }
  if (!largest || on_thick < warning_constants.thick_share * on_planes)
    return std::nullopt;
  const double thin = warning_constants.thick_noises * *largest->noise;
  return ResultWarning{
      "thick-planes",
      perCentOf (on_thick / on_planes) +
          " of the points on planes are on planes thicker than three times their noise "
          "(rms " +
          roundedLength (largest->rms()) + ", noise " +
          roundedLength (*largest->noise) +
          " of the largest), as hills are; for thinner planes give " +
          text.of ("threshold", roundedLength (thin))};
}

} // namespace pcl_ops::internal

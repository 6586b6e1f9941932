// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "size_classes.h"

#include "instance_metrics.h"

#include <cmath>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

/** \param[in] confusion of labelings
 * \param[in] sizes of its true planes
 * \param[in] limits between classes, ascending */
SizeClasses
classesOf (const Confusion& confusion,
           const std::vector<double>& sizes,
           const std::vector<double>& limits)
{
  SizeClasses classes (limits.size() + 1);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    classes[i].below = limits[i];
    classes[i + 1].from = limits[i];
  }
  const std::vector<bool> found_50 = foundTruePlanes (confusion, 0.50);
  const std::vector<bool> found_75 = foundTruePlanes (confusion, 0.75);
  for (std::size_t plane = 0; plane < sizes.size(); ++plane) {
    auto of_plane = classes.begin();
    while (of_plane->below && sizes[plane] >= *of_plane->below)
      ++of_plane;
    ++of_plane->planes;
    of_plane->found_50 += found_50[plane];
    of_plane->found_75 += found_75[plane];
  }
  return classes;
}

} // namespace

std::string
SizeClass::name (char between) const
{
  std::ostringstream text;
  text << (below ? "below" : "from") << between << below.value_or (from);
  return text.str();
}

SizeClasses
sizeClasses (const Confusion& confusion)
{
  const std::vector<std::size_t>& points = confusion.truth.points;
  return classesOf (
      confusion, {points.begin(), points.end()}, {200, 500, 1000, 3000, 10'000});
}

SizeClasses
widthClasses (const Confusion& confusion, const std::vector<double>& widths)
{
  return classesOf (confusion, widths, {0.03, 0.06, 0.12, 0.25, 1.0});
}

std::vector<double>
widthsOf (const XyzCloud& cloud, const PlaneIds& planes)
{
  constexpr double squared_side_over_variance = 12.0; // of an even spread
  std::vector<double> widths;
  for (const PlaneSegment& plane : planesOf (cloud, planes, {})) {
    const std::optional<PlaneFit> fit = fitPlane (plane.moments);
    widths.push_back (fit ? std::sqrt (squared_side_over_variance * fit->variances[1])
                          : 0.0);
  }
  return widths;
}

} // namespace pcl_ops::evaluation

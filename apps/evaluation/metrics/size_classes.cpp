// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "size_classes.h"

#include "instance_metrics.h"

#include <cmath>

namespace pcl_ops::evaluation {

namespace {

template <typename Size>
std::vector<SizeClass<Size>>
emptyClasses (const std::vector<Size>& limits)
{
  std::vector<SizeClass<Size>> classes (1);
  for (const Size limit : limits) {
    classes.back().below = limit;
    classes.emplace_back();
    classes.back().from = limit;
  }
  return classes;
}

/** \param[in] confusion of labellings
 * \param[in] sizes of its true planes
 * \param[in] limits between classes, ascending */
template <typename Size>
std::vector<SizeClass<Size>>
classesOf (const Confusion& confusion,
           const std::vector<Size>& sizes,
           const std::vector<Size>& limits)
{
  const std::vector<bool> found_50 = foundTruePlanes (confusion, 0.50);
  const std::vector<bool> found_75 = foundTruePlanes (confusion, 0.75);
  std::vector<SizeClass<Size>> classes = emptyClasses (limits);
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

std::vector<PointsClass>
sizeClasses (const Confusion& confusion)
{
  return classesOf<std::size_t> (
      confusion, confusion.truth.points, {200, 500, 1000, 3000, 10'000});
}

std::vector<WidthClass>
widthClasses (const Confusion& confusion, const std::vector<double>& widths)
{
  return classesOf<double> (confusion, widths, {0.03, 0.06, 0.12, 0.25, 1.0});
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

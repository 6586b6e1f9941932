// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "extent/planar_hull.h"

#include "extent/planar_ring.h"
#include "geometry/planar_area.h"

#include <algorithm>

namespace pcl_ops::internal {

namespace {

namespace geometry = boost::geometry;

} // namespace

PlanarPoints
hullOfAll (const PlanarPoints& points)
{
  constexpr std::size_t corners_of_an_area = 3;
  if (points.size() < corners_of_an_area)
    return {};
  const double scale = unitScale (points);
  geometry::model::multi_point<RingPoint> cloud;
  cloud.reserve (points.size());
  for (const Eigen::Vector2d& point : points)
    cloud.emplace_back (scale * point.x(), scale * point.y());
  Ring ring;
  geometry::convex_hull (cloud, ring);
  PlanarPoints hull;
  double longest = 0.0;
  for (const RingPoint& point : ring) {
    hull.emplace_back (point.x() / scale, point.y() / scale);
    longest = std::max (longest, (hull.back() - hull.front()).norm());
  }
  // Rounding of the inputs (single precision) alone can give a line this much width.
  constexpr double smallest_width = 1e-5;
  if (hull.size() < corners_of_an_area ||
      !(areaOf (hull) > smallest_width * longest * longest))
    return {};
  return hull;
}

} // namespace pcl_ops::internal

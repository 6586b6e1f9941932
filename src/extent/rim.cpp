// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "extent/rim.h"

#include "base/random.h"
#include "extent/planar_ring.h"
#include "geometry/planar_area.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_ops::internal {

namespace {

/** \brief How far inside a convex hull each point lies; below 0 outside. */
std::vector<double>
depthsWithin (const PlanarPoints& hull, const PlanarPoints& points)
{
  std::vector<double> depths (points.size(), std::numeric_limits<double>::infinity());
  for (std::size_t e = 0; e < hull.size(); ++e) {
    const Eigen::Vector2d edge = (hull[(e + 1) % hull.size()] - hull[e]).normalized();
    const Eigen::Vector2d inwards (-edge.y(), edge.x());
    const double offset = inwards.dot (hull[e]);
    for (std::size_t i = 0; i < points.size(); ++i)
      depths[i] = std::min (depths[i], inwards.dot (points[i]) - offset);
  }
  return depths;
}

/** \brief The points no deeper within a hull than \p depth. */
PlanarPoints
splitOff (PlanarPoints& points, const std::vector<double>& depths, double depth)
{
  PlanarPoints off, left;
  for (std::size_t i = 0; i < points.size(); ++i)
    (depths[i] <= depth ? off : left).push_back (points[i]);
  points.swap (left);
  return off;
}

// The depth of a corner is a rounding away from 0.
double
depthOfCorners (const PlanarPoints& hull)
{
  constexpr double rounding = 1e-12;
  double largest = 0.0;
  for (const Eigen::Vector2d& corner : hull)
    largest = std::max (largest, corner.lpNorm<Eigen::Infinity>());
  return rounding * largest;
}

/** \brief A hull around all but a few per cent of the points, from a sample of them. */
PlanarPoints
innerHull (const PlanarPoints& points)
{
  constexpr std::size_t sample_size = 2048;
  constexpr std::size_t one_outside_in = 32;
  if (points.size() <= sample_size)
    return {};
  RandomGenerator generator; // of the standard's own seed: the result has none
  PlanarPoints sample;
  for (std::size_t i = 0; i < sample_size; ++i)
    sample.push_back (
        points[drawBelow (generator, static_cast<std::uint32_t> (points.size()))]);
  PlanarPoints hull = hullOfAll (sample);
  while (!hull.empty() && sample.size() > sample_size - sample_size / one_outside_in) {
    splitOff (sample, depthsWithin (hull, sample), depthOfCorners (hull));
    hull = hullOfAll (sample);
  }
  return hull;
}

} // namespace

PlanarPoints
hullOfAll (const PlanarPoints& points)
{
  constexpr std::size_t corners_of_an_area = 3;
  if (points.size() < corners_of_an_area)
    return {};
  const double scale = unitScale (points);
  boost::geometry::model::multi_point<RingPoint> cloud;
  cloud.reserve (points.size());
  for (const Eigen::Vector2d& point : points)
    cloud.emplace_back (scale * point.x(), scale * point.y());
  Ring ring;
  boost::geometry::convex_hull (cloud, ring);
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

Rim::Rim (const PlanarPoints& points) : inner_hull_ (innerHull (points))
{
  PlanarPoints all = points;
  outer_ =
      inner_hull_.empty() ? all : splitOff (all, depthsWithin (inner_hull_, all), 0.0);
}

PlanarPoints
Rim::hull() const
{
  PlanarPoints points = outer_;
  points.insert (points.end(), inner_hull_.begin(), inner_hull_.end());
  return hullOfAll (points);
}

std::size_t
Rim::takeOff (const PlanarPoints& hull, std::size_t fewest)
{
  if (outer_.empty())
    return 0;
  const std::vector<double> depths = depthsWithin (hull, outer_);
  std::vector<double> ordered = depths;
  const auto last = ordered.begin() +
                    static_cast<std::ptrdiff_t> (std::min (fewest, ordered.size()) - 1);
  std::nth_element (ordered.begin(), last, ordered.end());
  return splitOff (outer_, depths, std::max (*last, depthOfCorners (hull))).size();
}

} // namespace pcl_ops::internal

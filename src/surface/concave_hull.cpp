// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/surface/concave_hull.h>
#include <pcl/point_types.h>

#include "extent/planar_ring.h"
#include "thinning.h"
#include <pcl_ops/surface/concave_hull.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

using namespace internal;

namespace {

namespace geometry = boost::geometry;

RingPoint
toPoint (const Eigen::Vector2d& point)
{
  return {point.x(), point.y()};
}

Ring
toRing (const PlanarPoints& outline)
{
  Ring ring;
  std::transform (outline.begin(), outline.end(), std::back_inserter (ring), toPoint);
  return ring;
}

PlanarPoints
pointsWithin (const PlanarPoints& outline, const PlanarPoints& points)
{
  const Ring ring = toRing (outline);
  PlanarPoints within;
  std::copy_if (points.begin(),
                points.end(),
                std::back_inserter (within),
                [&] (const Eigen::Vector2d& point) {
                  return geometry::covered_by (toPoint (point), ring);
                });
  return within;
}

std::size_t
weightWithin (const Ring& ring, const WeightedPoints& points)
{
  std::size_t weight = 0;
  for (std::size_t i = 0; i < points.points.size(); ++i)
    if (geometry::covered_by (toPoint (points.points[i]), ring))
      weight += points.weights[i];
  return weight;
}

/** \brief The largest of the outlines, counter-clockwise; empty if there is none. */
Ring
largestOutline (const PlanarPoints& points, double alpha)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector2d& point : points)
    cloud->push_back (
        {static_cast<float> (point.x()), static_cast<float> (point.y()), 0.0f});
  pcl::ConcaveHull<pcl::PointXYZ> concave;
  concave.setInputCloud (cloud);
  concave.setDimension (2);
  concave.setAlpha (alpha);
  concave.setKeepInformation (true);
  pcl::PointCloud<pcl::PointXYZ> corners;
  std::vector<pcl::Vertices> polygons;
  concave.reconstruct (corners, polygons);
  pcl::PointIndices indices;
  concave.getHullPointIndices (indices);
  Ring largest;
  for (const pcl::Vertices& polygon : polygons) {
    Ring ring;
    for (const auto vertex : polygon.vertices)
      ring.push_back (
          toPoint (points[static_cast<std::size_t> (indices.indices[vertex])]));
    if (std::abs (geometry::area (ring)) > std::abs (geometry::area (largest)))
      largest = ring;
  }
  geometry::correct (largest);
  return largest;
}

} // namespace

PlanarPoints
concaveHull (const PlanarPoints& points, double alpha)
{
  constexpr double least_inside = 0.99;
  constexpr double most_outside_convex = 0.005;
  constexpr double spacings_per_alpha = 6.0;
  constexpr double cells_per_alpha = 2.0;
  constexpr double growth = 1.5;
  constexpr int most_attempts = 8;
  const PlanarPoints convex = convexHull (points, most_outside_convex);
  if (convex.empty())
    return {};
  const auto number = static_cast<double> (
      std::count_if (points.begin(), points.end(), [] (const Eigen::Vector2d& point) {
        return point.allFinite();
      }));
  const double spacing = std::sqrt (geometry::area (toRing (convex)) / number);
  double radius = alpha > 0.0 ? alpha : spacings_per_alpha * spacing;
  const WeightedPoints thinned =
      thinInside (pointsWithin (convex, points), radius / cells_per_alpha);
  constexpr std::size_t fewest_for_qhull = 4;
  if (thinned.points.size() < fewest_for_qhull)
    return convex;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    const Ring ring = largestOutline (thinned.points, radius);
    if (geometry::is_valid (ring) &&
        static_cast<double> (weightWithin (ring, thinned)) >= least_inside * number) {
      Ring corners;
      constexpr double straight = 1e-3;
      geometry::simplify (ring, corners, straight * spacing);
      geometry::correct (corners);
      PlanarPoints outline;
      for (const RingPoint& corner : corners)
        outline.emplace_back (corner.x(), corner.y());
      return outline;
    }
    radius *= growth;
  }
  return convex;
}

} // namespace pcl_ops

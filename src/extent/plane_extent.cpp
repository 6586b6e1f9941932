// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "extent/rim.h"
#include "geometry/planar_area.h"
#include "geometry/plane_axes.h"
#include <pcl_ops/plane_extent.h>

#include <algorithm>
#include <limits>

namespace pcl_ops {

using namespace internal;

namespace {

/** \brief A rectangle around points, by its side u and the one to the left of it. */
struct Rectangle {
  Eigen::Vector2d u = Eigen::Vector2d::UnitX();
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();

  Eigen::Vector2d
  left () const
  {
    return {-u.y(), u.x()};
  }
  Eigen::Vector2d
  sides () const
  {
    return high - low;
  }
  Eigen::Vector2d
  center () const
  {
    const Eigen::Vector2d middle = 0.5 * (low + high);
    return middle.x() * u + middle.y() * left();
  }
};

Rectangle
rectangleAlong (const Eigen::Vector2d& u, const PlanarPoints& points)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Rectangle rectangle;
  rectangle.u = u;
  rectangle.low.setConstant (infinity);
  rectangle.high.setConstant (-infinity);
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d turned (u.dot (point), rectangle.left().dot (point));
    rectangle.low = rectangle.low.cwiseMin (turned);
    rectangle.high = rectangle.high.cwiseMax (turned);
  }
  return rectangle;
}

// One side of the smallest rectangle lies along an edge of the convex hull.
Rectangle
smallestRectangle (const PlanarPoints& hull)
{
  Rectangle smallest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
    const Rectangle rectangle = rectangleAlong (edge.normalized(), hull);
    const double area = rectangle.sides().prod();
    if (area < least) {
      least = area;
      smallest = rectangle;
    }
  }
  return smallest;
}

bool
isFinite (const Eigen::Vector2d& point)
{
  return point.allFinite();
}

// Of points on one line: its direction, by two that lie far apart.
Eigen::Vector2d
directionOf (const PlanarPoints& points)
{
  const auto farthestFrom = [&] (const Eigen::Vector2d& from) {
    return *std::max_element (
        points.begin(), points.end(), [&] (const auto& first, const auto& second) {
          return (first - from).squaredNorm() < (second - from).squaredNorm();
        });
  };
  const Eigen::Vector2d end = farthestFrom (points.front());
  const Eigen::Vector2d along = farthestFrom (end) - end;
  return along.isZero (0.0) ? Eigen::Vector2d::UnitX() : along.normalized();
}

Rectangle
rectangleAlongLine (const PlanarPoints& points)
{
  if (points.empty())
    return {};
  Rectangle rectangle = rectangleAlong (directionOf (points), points);
  rectangle.low.y() = rectangle.high.y() = rectangle.center().dot (rectangle.left());
  return rectangle;
}

PlanarPoints
finiteOf (const PlanarPoints& points)
{
  PlanarPoints finite;
  finite.reserve (points.size());
  std::copy_if (points.begin(), points.end(), std::back_inserter (finite), isFinite);
  return finite;
}

} // namespace

PlaneFrame::PlaneFrame (const Eigen::Vector3d& origin, const Eigen::Vector3d& normal)
: origin_ (origin), axes_ (planeAxes (normal))
{}

PlanarPoints
convexHull (const PlanarPoints& points, double max_outside)
{
  constexpr double edge_density = 0.5;
  constexpr std::size_t layers = 16;
  const PlanarPoints finite = finiteOf (points);
  const auto number = static_cast<double> (finite.size());
  const auto budget = static_cast<std::size_t> (max_outside * number);
  Rim rim (finite);
  PlanarPoints hull = rim.hull();
  for (std::size_t outside = 0; !hull.empty();) {
    const std::size_t layer = rim.takeOff (hull, budget / layers + 1);
    outside += layer;
    if (outside > budget)
      break;
    const PlanarPoints next = rim.hull();
    const double area = areaOf (next);
    const double lost = areaOf (hull) - area;
    const bool is_fringe =
        static_cast<double> (layer) * area < edge_density * number * lost;
    if (next.empty() || !is_fringe)
      break;
    hull = next;
  }
  return hull;
}

PlaneExtent
extentOf (const PlanarRings& rings, const PlanarPoints& points, const PlaneFrame& frame)
{
  const PlanarPoints outline = rings.empty() ? PlanarPoints() : rings.front();
  const PlanarPoints hull = hullOfAll (outline);
  const Rectangle rectangle =
      hull.empty() ? rectangleAlongLine (finiteOf (points)) : smallestRectangle (hull);
  const Eigen::Vector2d sides = rectangle.sides();
  const bool is_long = sides.x() >= sides.y();
  PlaneExtent extent;
  for (const Eigen::Vector2d& corner : outline)
    extent.hull.push_back (frame.toSpace (corner));
  extent.area = areaOf (outline);
  extent.center = frame.toSpace (rectangle.center());
  extent.long_axis = frame.directionInSpace (is_long ? rectangle.u : rectangle.left());
  extent.short_axis =
      frame.directionInSpace (is_long ? rectangle.left() : -rectangle.u);
  extent.length = sides.maxCoeff();
  extent.width = sides.minCoeff();
  for (std::size_t hole = 1; hole < rings.size(); ++hole) {
    extent.area += areaOf (rings[hole]); // below 0
    extent.holes.emplace_back();
    for (const Eigen::Vector2d& corner : rings[hole])
      extent.holes.back().push_back (frame.toSpace (corner));
  }
  return extent;
}

PlanarPoints
pointsOnPlane (const CloudView& cloud,
               const PlaneSegment& plane,
               const PlaneFrame& frame)
{
  PlanarPoints points;
  points.reserve (plane.inliers.size());
  for (const pcl::index_t index : plane.inliers) {
    const float* const point = cloud[static_cast<std::size_t> (index)];
    points.push_back (frame.toPlane (Eigen::Vector3d (point[0], point[1], point[2])));
  }
  return points;
}

PlaneExtent
planeExtent (const CloudView& cloud, const PlaneSegment& plane)
{
  const PlaneFrame frame (plane.centroid, plane.normal);
  const PlanarPoints points = pointsOnPlane (cloud, plane, frame);
  return extentOf ({convexHull (points)}, points, frame);
}

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "alpha_shape.h"

#include <boost/polygon/voronoi.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace pcl_ops::internal {

namespace {

using Site = boost::polygon::point_data<std::int32_t>;
using Diagram = boost::polygon::voronoi_diagram<double>;

/** \brief Indices of the first and the last point of a side; the inside is to its left.
 */
using Side = std::pair<std::size_t, std::size_t>;

/** \brief Points rounded to integers, whose Voronoi diagram Boost finds without further
 * rounding. */
struct IntegerPoints {
  std::vector<Site> sites;
  /** \brief Integer steps per unit of the points. */
  double scale = 1.0;
};

/** \brief Scales points to the range of integers from -2^30 to 2^30 and rounds them. */
IntegerPoints
integerPointsOf (const PlanarPoints& points)
{
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : points)
    box.extend (point);
  constexpr double largest_integer = 1U << 30U;
  const double half_extent = 0.5 * box.sizes().maxCoeff();
  IntegerPoints integers;
  if (!(half_extent > 0.0))
    return integers;
  integers.scale = largest_integer / half_extent;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d scaled_point = integers.scale * (point - box.center());
    integers.sites.emplace_back (
        static_cast<std::int32_t> (std::lround (scaled_point.x())),
        static_cast<std::int32_t> (std::lround (scaled_point.y())));
  }
  return integers;
}

/** \brief The points around a vertex of the Voronoi diagram, counter-clockwise: the
 * corners of a Delaunay triangle, or more points on one circle. */
std::vector<std::size_t>
pointsAround (const Diagram::vertex_type& vertex)
{
  std::vector<std::size_t> points;
  const Diagram::edge_type* edge = vertex.incident_edge();
  do {
    points.push_back (edge->cell()->source_index());
    edge = edge->rot_next();
  }
  while (edge != vertex.incident_edge());
  return points;
}

/** \brief The sides that only one triangle has, among the triangles whose circumscribed
 * circle has a radius of alpha or less; ascending. */
std::vector<Side>
outerSides (const IntegerPoints& integers, double alpha)
{
  Diagram diagram;
  boost::polygon::construct_voronoi (
      integers.sites.begin(), integers.sites.end(), &diagram);
  std::vector<Side> sides;
  for (const Diagram::vertex_type& vertex : diagram.vertices()) {
    const std::vector<std::size_t> points = pointsAround (vertex);
    const Site& corner = integers.sites[points.front()];
    const double radius = std::hypot (vertex.x() - corner.x(), vertex.y() - corner.y());
    if (radius > alpha * integers.scale)
      continue;
    for (std::size_t i = 0; i < points.size(); ++i)
      sides.emplace_back (points[i], points[(i + 1) % points.size()]);
  }
  std::sort (sides.begin(), sides.end());
  std::vector<Side> outer;
  for (const Side& side : sides)
    if (!std::binary_search (
            sides.begin(), sides.end(), Side (side.second, side.first)))
      outer.push_back (side);
  return outer;
}

} // namespace

std::vector<PlanarPoints>
alphaShapeRings (const PlanarPoints& points, double alpha)
{
  constexpr std::size_t not_in_path = std::numeric_limits<std::size_t>::max();
  const std::vector<Side> sides = outerSides (integerPointsOf (points), alpha);
  // The sides that are not yet in a ring: from first to last point.
  std::multimap<std::size_t, std::size_t> sides_left (sides.begin(), sides.end());
  std::vector<std::size_t> position_in_path (points.size(), not_in_path);
  std::vector<std::size_t> path;
  std::vector<PlanarPoints> rings;
  // As many sides lead to a point as from it: a path always comes back to one of its
  // points and closes a ring.
  while (!sides_left.empty()) {
    if (path.empty()) {
      path.push_back (sides_left.begin()->first);
      position_in_path[path.back()] = 0;
    }
    const auto side = sides_left.find (path.back());
    const std::size_t point = side->second;
    sides_left.erase (side);
    if (position_in_path[point] == not_in_path) {
      position_in_path[point] = path.size();
      path.push_back (point);
      continue;
    }
    PlanarPoints& ring = rings.emplace_back();
    const std::size_t first_of_ring = position_in_path[point];
    for (std::size_t i = first_of_ring; i < path.size(); ++i) {
      ring.push_back (points[path[i]]);
      position_in_path[path[i]] = not_in_path;
    }
    path.resize (first_of_ring);
    // The path goes on from this point, unless it is empty and the point has no more
    // sides.
    if (sides_left.count (point) > 0 || !path.empty()) {
      position_in_path[point] = path.size();
      path.push_back (point);
    }
  }
  return rings;
}

} // namespace pcl_ops::internal

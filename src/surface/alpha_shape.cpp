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

/** \brief Points as integers, for which Boost finds neighbors without rounding. */
struct WholeNumbers {
  std::vector<Site> sites;
  /** \brief Integer steps per meter [1/m]. */
  double scale = 1.0;
};

WholeNumbers
wholeNumbersOf (const PlanarPoints& points)
{
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : points)
    box.extend (point);
  constexpr double largest = 1U << 30U;
  const double half_extent = 0.5 * box.sizes().maxCoeff();
  WholeNumbers whole;
  if (!(half_extent > 0.0))
    return whole;
  whole.scale = largest / half_extent;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d place = whole.scale * (point - box.center());
    whole.sites.emplace_back (static_cast<std::int32_t> (std::lround (place.x())),
                              static_cast<std::int32_t> (std::lround (place.y())));
  }
  return whole;
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

/** \brief The sides that only one triangle has among those with a circumscribed circle
 * of radius alpha or less; ascending. */
std::vector<Side>
outerSides (const WholeNumbers& whole, double alpha)
{
  Diagram diagram;
  boost::polygon::construct_voronoi (whole.sites.begin(), whole.sites.end(), &diagram);
  std::vector<Side> sides;
  for (const Diagram::vertex_type& vertex : diagram.vertices()) {
    const std::vector<std::size_t> points = pointsAround (vertex);
    const Site& corner = whole.sites[points.front()];
    if (std::hypot (vertex.x() - corner.x(), vertex.y() - corner.y()) >
        alpha * whole.scale)
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
  constexpr std::size_t not_passed = std::numeric_limits<std::size_t>::max();
  const std::vector<Side> sides = outerSides (wholeNumbersOf (points), alpha);
  std::multimap<std::size_t, std::size_t> next (sides.begin(), sides.end());
  std::vector<std::size_t> position (points.size(), not_passed);
  std::vector<std::size_t> path;
  std::vector<PlanarPoints> rings;
  // As many sides lead to a point as from it: a path always comes back to one of its
  // points and closes a ring.
  while (!next.empty()) {
    if (path.empty()) {
      path.push_back (next.begin()->first);
      position[path.back()] = 0;
    }
    const auto side = next.find (path.back());
    const std::size_t point = side->second;
    next.erase (side);
    if (position[point] == not_passed) {
      position[point] = path.size();
      path.push_back (point);
      continue;
    }
    PlanarPoints& ring = rings.emplace_back();
    const std::size_t first = position[point];
    for (std::size_t i = first; i < path.size(); ++i) {
      ring.push_back (points[path[i]]);
      position[path[i]] = not_passed;
    }
    path.resize (first);
    // The path goes on from this point, unless it is empty and the point has no more
    // sides.
    if (next.count (point) > 0 || !path.empty()) {
      position[point] = path.size();
      path.push_back (point);
    }
  }
  return rings;
}

} // namespace pcl_ops::internal

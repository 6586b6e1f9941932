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
#include <tuple>

namespace pcl_ops::internal {

namespace {

using Site = boost::polygon::point_data<std::int32_t>;
using Diagram = boost::polygon::voronoi_diagram<double>;

/** \brief A side of triangles: the indices of the points where it begins and ends. The
 * inside is on its left, as seen along the side. */
struct Side {
  std::size_t begin, end;

  bool
  operator<(const Side& other) const
  {
    return std::tie (begin, end) < std::tie (other.begin, other.end);
  }
};

/** \brief Points scaled and rounded to integers, whose Voronoi diagram Boost finds
 * without further rounding. */
struct IntegerPoints {
  /** \brief The integer points, in the order of the points. */
  std::vector<Site> sites;
  /** \brief Integer steps per unit of the points. */
  double scale = 1.0;
};

/** \brief Scales points to the range of integers from -2^30 to 2^30 and rounds them.
 * \return no sites if all points are equal */
IntegerPoints
integerPointsOf (const PlanarPoints& points)
{
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : points)
    box.extend (point);
  constexpr double max_integer = 1U << 30U;
  const double half_extent = 0.5 * box.sizes().maxCoeff();
  IntegerPoints integers;
  if (!(half_extent > 0.0))
    return integers;
  integers.scale = max_integer / half_extent;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d scaled_point = integers.scale * (point - box.center());
    integers.sites.emplace_back (
        static_cast<std::int32_t> (std::lround (scaled_point.x())),
        static_cast<std::int32_t> (std::lround (scaled_point.y())));
  }
  return integers;
}

/** \brief The indices of the points around a vertex of the Voronoi diagram,
 * counter-clockwise: the corners of a Delaunay triangle, or more points on one circle.
 */
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
 * circle has a radius of alpha or less; ascending. They run counter-clockwise around
 * their triangle, so that a common side of two triangles is there in both directions.
 * \param[in] alpha in the unit of the points before they were scaled */
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
      sides.push_back ({points[i], points[(i + 1) % points.size()]});
  }
  std::sort (sides.begin(), sides.end());
  std::vector<Side> outer;
  for (const Side& side : sides)
    if (!std::binary_search (sides.begin(), sides.end(), Side{side.end, side.begin}))
      outer.push_back (side);
  return outer;
}

/** \brief A path along sides, through each point at most once. */
class Path {
public:
  explicit Path (std::size_t points) : index_in_path_ (points, not_in_path) {}

  bool
  empty () const
  {
    return path_.empty();
  }

  /** \brief The last point. */
  std::size_t
  back () const
  {
    return path_.back();
  }

  bool
  contains (std::size_t point) const
  {
    return index_in_path_[point] != not_in_path;
  }

  void
  append (std::size_t point)
  {
    index_in_path_[point] = path_.size();
    path_.push_back (point);
  }

  /** \brief Removes the part of the path from one of its points on, and returns it. */
  std::vector<std::size_t>
  cutOffFrom (std::size_t point)
  {
    const auto first =
        path_.begin() + static_cast<std::ptrdiff_t> (index_in_path_[point]);
    const std::vector<std::size_t> removed (first, path_.end());
    path_.erase (first, path_.end());
    for (const std::size_t removed_point : removed)
      index_in_path_[removed_point] = not_in_path;
    return removed;
  }

private:
  static constexpr std::size_t not_in_path = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> path_;          // indices of points
  std::vector<std::size_t> index_in_path_; // of each point
};

} // namespace

std::vector<PlanarPoints>
alphaShapeRings (const PlanarPoints& points, double alpha)
{
  // The ends of the sides that are not yet in a ring, by where they begin.
  std::multimap<std::size_t, std::size_t> unused_sides;
  for (const Side& side : outerSides (integerPointsOf (points), alpha))
    unused_sides.emplace (side.begin, side.end);
  Path path (points.size());
  std::vector<PlanarPoints> rings;
  // As many sides end at a point as begin there: a path always comes back to one of its
  // points and closes a ring.
  while (!unused_sides.empty()) {
    if (path.empty())
      path.append (unused_sides.begin()->first);
    const auto side = unused_sides.find (path.back());
    const std::size_t point = side->second;
    unused_sides.erase (side);
    if (!path.contains (point)) {
      path.append (point);
      continue;
    }
    PlanarPoints& ring = rings.emplace_back();
    for (const std::size_t corner : path.cutOffFrom (point))
      ring.push_back (points[corner]);
    // The path goes on from this point, unless it is empty and no more sides begin at
    // the point.
    if (unused_sides.count (point) > 0 || !path.empty())
      path.append (point);
  }
  return rings;
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Boost 1.74 prints a deprecation note on one of its own headers in every build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#undef BOOST_ALLOW_DEPRECATED_HEADERS

#include "plane_outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

BOOST_GEOMETRY_REGISTER_POINT_2D (Eigen::Vector2d, double, cs::cartesian, x(), y())

namespace pcl_ops::apps {

namespace {

/** \brief A corner of the outline with the edges that begin at it. */
struct Corner {
  Eigen::Vector2d point;
  /** \brief Ends of those edges that \ref followEdges has not taken yet. */
  std::vector<Corner*> next;
  /** \brief Whether the corner is on the path of \ref followEdges. */
  bool is_on_path = false;

  /** \brief Removes an edge from the corner and returns its end. Of several edges it
   * takes the one along the same part of the plane: the next one clockwise from the
   * direction to \p previous.
   * \param[in] previous the corner before this one on the path; nullptr: the first edge
   * is taken */
  Corner*
  takeNext (const Corner* previous)
  {
    const auto angle_of = [this] (const Corner* other) {
      const Eigen::Vector2d direction = other->point - point;
      return std::atan2 (direction.y(), direction.x());
    };
    const auto clockwise_turn_to = [&] (const Corner* other) {
      const double turn = angle_of (previous) - angle_of (other);
      return turn <= 0.0 ? turn + 2.0 * M_PI : turn;
    };
    auto taken = next.begin();
    if (previous != nullptr && next.size() > 1)
      taken = std::min_element (
          next.begin(), next.end(), [&] (const Corner* one, const Corner* other) {
            return clockwise_turn_to (one) < clockwise_turn_to (other);
          });
    Corner* const end = *taken;
    next.erase (taken);
    return end;
  }
};

/** \brief Follows edges from a corner until a corner has none left. Whenever the path
 * comes back to one of its corners, the loop is removed from the path and becomes a
 * ring. If as many edges end at each corner as begin there, the path ends where it
 * began, and all its edges are in rings; else edges remain on the path and are lost. */
void
followEdges (Corner* corner, std::vector<PlanarPoints>& rings)
{
  std::vector<Corner*> path;
  for (;;) {
    if (corner->is_on_path) {
      const auto loop = std::find (path.rbegin(), path.rend(), corner).base() - 1;
      PlanarPoints& ring = rings.emplace_back();
      for (auto on_loop = loop; on_loop != path.end(); ++on_loop) {
        ring.push_back ((*on_loop)->point);
        (*on_loop)->is_on_path = false;
      }
      path.erase (loop, path.end());
    }
    const Corner* previous = path.empty() ? nullptr : path.back();
    path.push_back (corner);
    corner->is_on_path = true;
    if (corner->next.empty())
      break;
    corner = corner->takeNext (previous);
  }
  for (Corner* on_path : path)
    on_path->is_on_path = false;
}

/** \brief Returns the rings along the edges that remain after opposite ones cancel. A
 * ring visits no corner twice. Edges that are in no ring are left out (\ref
 * followEdges).
 * \param[in] unit of the coordinates of the edges [m] */
std::vector<PlanarPoints>
ringsAlong (const std::vector<OutlineEdge>& edges, const PlaneFrame& frame, double unit)
{
  // The lower end of an edge, then the higher one, in the order of LatticePoint.
  using Ends = std::pair<LatticePoint, LatticePoint>;
  // Number of edges from the lower to the higher end, minus the number of opposite
  // ones.
  std::map<Ends, int> surplus;
  for (const OutlineEdge& edge : edges)
    surplus[std::minmax (edge.from, edge.to)] += edge.from < edge.to ? 1 : -1;
  std::map<LatticePoint, Corner> corners;
  for (const auto& [ends, count] : surplus)
    for (int i = 0; i < std::abs (count); ++i) {
      Corner& lower = corners[ends.first];
      Corner& higher = corners[ends.second];
      if (count > 0)
        lower.next.push_back (&higher);
      else
        higher.next.push_back (&lower);
    }
  for (auto& [position, corner] : corners)
    corner.point = frame.toPlane (
        unit * Eigen::Map<const Eigen::Matrix<std::int64_t, 3, 1>> (position.data())
                   .cast<double>());
  std::vector<PlanarPoints> rings;
  for (auto& [position, corner] : corners)
    while (!corner.next.empty())
      followEdges (&corner, rings);
  return rings;
}

/** \brief Removes spikes, where a ring goes to a corner and straight back. They arise
 * where two tiles round a point to different points of the lattice.
 * \param[in] unit spacing of the lattice [m] */
PlanarPoints
withoutSpikes (const PlanarPoints& ring, double unit)
{
  // Two tiles may round each coordinate of a point to two neighboring numbers, so that
  // the corners are up to sqrt (3) units apart. The rest is a margin.
  constexpr double max_rounding = 4.0; // [unit]
  const auto are_same = [unit] (const Eigen::Vector2d& one,
                                const Eigen::Vector2d& other) {
    return (one - other).norm() < max_rounding * unit;
  };
  PlanarPoints kept;
  for (const Eigen::Vector2d& corner : ring) {
    kept.push_back (corner);
    while (kept.size() > 2 && are_same (kept[kept.size() - 3], kept.back()))
      kept.resize (kept.size() - 2);
  }
  // The ring is closed, so that its last or its first corner may be the tip of a spike,
  // again and again after a tip is removed.
  while (kept.size() > 2)
    if (are_same (kept[kept.size() - 2], kept.front()))
      kept.resize (kept.size() - 2);
    else if (are_same (kept.back(), kept[1]))
      kept.erase (kept.begin(), kept.begin() + 2);
    else
      break;
  return kept;
}

/** \brief Moves each corner by a distance [m] to the right of the two sides that meet
 * there, along their bisector: a part grows, a hole shrinks. */
PlanarPoints
movedOutwards (const PlanarPoints& ring, double distance)
{
  // Unit vector to the right of the side that begins at a corner.
  const auto right_of_side = [&] (std::size_t i) {
    const Eigen::Vector2d side = ring[(i + 1) % ring.size()] - ring[i % ring.size()];
    return Eigen::Vector2d (side.y(), -side.x()).normalized();
  };
  PlanarPoints moved;
  for (std::size_t i = 0; i < ring.size(); ++i)
    moved.push_back (
        ring[i] +
        distance *
            (right_of_side (i + ring.size() - 1) + right_of_side (i)).normalized());
  return moved;
}

namespace geometry = boost::geometry;

/** \brief A part of the plane, counter-clockwise, or a hole, clockwise. */
struct SignedRing {
  static constexpr bool is_clockwise = false, is_closed = false;
  geometry::model::ring<Eigen::Vector2d, is_clockwise, is_closed> corners;
  geometry::model::box<Eigen::Vector2d> box;
  /** \brief Area inside the ring [m^2], below zero for a hole. */
  double area = 0.0;

  explicit SignedRing (const PlanarPoints& ring) : corners (ring.begin(), ring.end())
  {
    geometry::envelope (corners, box);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      // The signed area of a triangle with corner 0.
      const Eigen::Vector2d a = ring[i] - ring[0];
      const Eigen::Vector2d b = ring[i + 1] - ring[0];
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  }

  /** \brief Whether this hole is in a part. The middle of a side is tested, as the two
   * may share corners. */
  bool
  isIn (const SignedRing& part) const
  {
    const Eigen::Vector2d middle = 0.5 * (corners[0] + corners[1]);
    return geometry::covered_by (box, part.box) &&
           geometry::within (middle, part.corners);
  }
};

/** \brief Returns the rings without spikes, by falling absolute area.
 * \param[in] unit as for \ref withoutSpikes [m] */
std::vector<SignedRing>
signedRings (const std::vector<PlanarPoints>& rings_with_spikes, double unit)
{
  std::vector<SignedRing> rings;
  for (const PlanarPoints& with_spikes : rings_with_spikes)
    if (const PlanarPoints ring = withoutSpikes (with_spikes, unit); ring.size() >= 3)
      rings.emplace_back (ring);
  const auto is_larger = [] (const SignedRing& one, const SignedRing& other) {
    return std::abs (one.area) > std::abs (other.area);
  };
  std::stable_sort (rings.begin(), rings.end(), is_larger);
  return rings;
}

/** \brief Returns the position of the smallest part around a hole. If no smaller part
 * is around it, it is the largest part, for which the slow test is left out.
 * \param[in] parts by falling area, at least one */
std::size_t
partAround (const SignedRing& hole, const std::vector<SignedRing>& parts)
{
  std::size_t part = parts.size() - 1;
  while (part > 0 && !hole.isIn (parts[part]))
    --part;
  return part;
}

} // namespace

std::vector<PlanarRings>
outlineOf (const std::vector<OutlineEdge>& edges,
           const PlaneFrame& frame,
           double unit,
           double points,
           double min_area)
{
  const std::vector<SignedRing> rings =
      signedRings (ringsAlong (edges, frame, unit), unit);
  std::vector<SignedRing> parts;
  std::vector<PlanarRings> outline;
  double area = 0.0; // of all parts, without their holes
  for (const SignedRing& ring : rings) {
    const bool is_part = ring.area > 0.0 && (parts.empty() || ring.area >= min_area);
    if (!is_part)
      continue;
    parts.push_back (ring);
    outline.push_back ({ring.corners});
    area += ring.area;
  }
  for (const SignedRing& hole : rings) {
    const bool is_hole = hole.area <= -min_area;
    if (!is_hole || parts.empty())
      continue;
    const std::size_t part = partAround (hole, parts);
    if (-hole.area < parts[part].area) {
      outline[part].push_back (hole.corners);
      area += hole.area;
    }
  }
  // How far the outermost points lie inside the boundary; measured on simulated roofs
  // and facades.
  constexpr double margin_in_spacings = 0.3;
  // Holes of overlapping rings may have a larger area than the parts together.
  const double spacing = std::sqrt (std::max (0.0, area) / points);
  for (PlanarRings& part : outline)
    for (PlanarPoints& ring : part)
      ring = movedOutwards (ring, margin_in_spacings * spacing);
  return outline;
}

} // namespace pcl_ops::apps

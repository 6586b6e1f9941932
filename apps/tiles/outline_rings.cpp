// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Boost 1.74 remarks in every build on a header it includes itself.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#undef BOOST_ALLOW_DEPRECATED_HEADERS

#include "outline_rings.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_ops::apps {

namespace {

namespace geometry = boost::geometry;
using PlanarPoint = geometry::model::d2::point_xy<double>;
using PlanarRing = geometry::model::ring<PlanarPoint, false, false>;
using Box = geometry::model::box<PlanarPoint>;

/** \brief Takes out what has an opposite. */
std::vector<OutlineEdge>
withoutOpposites (std::vector<OutlineEdge> edges)
{
  const auto ends = [] (const OutlineEdge& edge) {
    return std::minmax (edge.from, edge.to);
  };
  std::sort (edges.begin(), edges.end(), [&] (const auto& a, const auto& b) {
    return std::tuple (ends (a), a.from) < std::tuple (ends (b), b.from);
  });
  std::vector<OutlineEdge> left;
  std::size_t first_alike = 0;
  for (const OutlineEdge& edge : edges) {
    if (left.size() <= first_alike || ends (left.back()) != ends (edge))
      first_alike = left.size();
    if (left.size() > first_alike && left.back().from == edge.to)
      left.pop_back();
    else
      left.push_back (edge);
  }
  return left;
}

/** \brief Closed lines along edges that never meet a corner twice. */
class RingTracer {
public:
  RingTracer (const std::vector<OutlineEdge>& edges,
              const PlaneFrame& frame,
              double unit)
  {
    std::vector<LatticePlace> places;
    for (const OutlineEdge& edge : edges)
      places.push_back (edge.from);
    std::sort (places.begin(), places.end());
    places.erase (std::unique (places.begin(), places.end()), places.end());
    for (const LatticePlace& place : places)
      corners_.push_back (frame.toPlane (unit * Eigen::Vector3d (double (place[0]),
                                                                 double (place[1]),
                                                                 double (place[2]))));
    const auto number_of = [&] (const LatticePlace& place) {
      return static_cast<std::size_t> (
          std::lower_bound (places.begin(), places.end(), place) - places.begin());
    };
    next_.resize (places.size());
    for (const OutlineEdge& edge : edges)
      next_[number_of (edge.from)].push_back (number_of (edge.to));
    place_on_path_.assign (places.size(), none);
  }

  std::vector<PlanarPoints>
  trace ()
  {
    for (std::size_t first = 0; first < next_.size(); ++first)
      while (!next_[first].empty())
        follow (first);
    return std::move (rings_);
  }

private:
  static constexpr std::size_t none = std::size_t (-1);

  /** \brief Goes along edges until none is left to come back by. */
  void
  follow (std::size_t corner)
  {
    path_.clear();
    for (;;) {
      place_on_path_[corner] = path_.size();
      path_.push_back (corner);
      if (next_[corner].empty())
        break;
      corner = takeNext (corner);
      if (place_on_path_[corner] != none)
        closeRing (place_on_path_[corner]);
    }
    for (const std::size_t on_path : path_)
      place_on_path_[on_path] = none;
  }

  void
  closeRing (std::size_t first)
  {
    rings_.emplace_back();
    for (std::size_t i = first; i < path_.size(); ++i) {
      rings_.back().push_back (corners_[path_[i]]);
      place_on_path_[path_[i]] = none;
    }
    path_.resize (first);
  }

  /** \brief Where several edges leave, the one that stays at the same part of the
   * plane: the next one clockwise from where the path comes from. */
  std::size_t
  takeNext (std::size_t corner)
  {
    std::vector<std::size_t>& next = next_[corner];
    std::size_t best = 0;
    if (next.size() > 1 && path_.size() > 1) {
      const auto angle_of = [&] (std::size_t other) {
        const Eigen::Vector2d way = corners_[other] - corners_[corner];
        return std::atan2 (way.y(), way.x());
      };
      const double from = angle_of (path_[path_.size() - 2]);
      constexpr double full_turn = 6.283185307179586;
      double least = full_turn;
      for (std::size_t i = 0; i < next.size(); ++i) {
        double turn = from - angle_of (next[i]);
        turn += turn <= 0.0 ? full_turn : 0.0;
        if (turn < least) {
          least = turn;
          best = i;
        }
      }
    }
    const std::size_t result = next[best];
    next.erase (next.begin() + static_cast<std::ptrdiff_t> (best));
    return result;
  }

  PlanarPoints corners_;
  std::vector<std::vector<std::size_t>> next_;
  std::vector<std::size_t> path_;
  /** \brief Of each corner; none where it is not on the path. */
  std::vector<std::size_t> place_on_path_;
  std::vector<PlanarPoints> rings_;
};

/** \brief Takes off corners that a ring goes to and comes back from: where two tiles
 * round a point to different places of the lattice. */
PlanarPoints
withoutSpikes (const PlanarPoints& ring, double unit)
{
  const double near = 4.0 * unit;
  PlanarPoints left;
  for (const Eigen::Vector2d& corner : ring) {
    left.push_back (corner);
    while (left.size() > 2 && (left[left.size() - 3] - left.back()).norm() < near)
      left.resize (left.size() - 2);
  }
  return left;
}

/** \brief Moves each corner to the right of both of its sides. */
PlanarPoints
movedOut (const PlanarPoints& ring, double distance)
{
  const auto right_of = [&] (std::size_t i) {
    const Eigen::Vector2d side = ring[(i + 1) % ring.size()] - ring[i % ring.size()];
    return Eigen::Vector2d (side.y(), -side.x()).normalized();
  };
  PlanarPoints moved;
  for (std::size_t i = 0; i < ring.size(); ++i)
    moved.push_back (ring[i] +
                     distance *
                         (right_of (i + ring.size() - 1) + right_of (i)).normalized());
  return moved;
}

double
areaOf (const std::vector<PlanarRings>& outline)
{
  double area = 0.0;
  for (const PlanarRings& rings : outline)
    for (const PlanarPoints& ring : rings)
      for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const Eigen::Vector2d a = ring[i] - ring[0], b = ring[i + 1] - ring[0];
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
      }
  return area;
}

/** \brief A ring that goes round to the left, or a hole to the right. */
struct SignedRing {
  PlanarPoints corners;
  PlanarRing ring;
  Box box;
  double area = 0.0;
};

std::vector<SignedRing>
signedRings (const std::vector<PlanarPoints>& rings, double unit)
{
  std::vector<SignedRing> all;
  for (const PlanarPoints& traced : rings) {
    SignedRing ring{withoutSpikes (traced, unit), {}, {}, 0.0};
    for (const Eigen::Vector2d& corner : ring.corners)
      ring.ring.emplace_back (corner.x(), corner.y());
    if (ring.ring.size() < 3)
      continue;
    ring.box = geometry::return_envelope<Box> (ring.ring);
    ring.area = geometry::area (ring.ring);
    all.push_back (std::move (ring));
  }
  std::stable_sort (all.begin(), all.end(), [] (const auto& a, const auto& b) {
    return std::abs (a.area) > std::abs (b.area);
  });
  return all;
}

/** \brief Whether a hole is in a part. They may share corners, so that the middle of a
 * side is asked. */
bool
isIn (const SignedRing& hole, const SignedRing& part)
{
  if (!geometry::covered_by (hole.box, part.box))
    return false;
  const Eigen::Vector2d middle = 0.5 * (hole.corners[0] + hole.corners[1]);
  return geometry::within (PlanarPoint (middle.x(), middle.y()), part.ring);
}

} // namespace

std::vector<PlanarRings>
outlineOf (std::vector<OutlineEdge> edges,
           const PlaneFrame& frame,
           double unit,
           double points,
           double min_area)
{
  RingTracer tracer (withoutOpposites (std::move (edges)), frame, unit);
  std::vector<SignedRing> rings = signedRings (tracer.trace(), unit);
  std::vector<SignedRing> parts;
  std::vector<PlanarRings> outline;
  for (const SignedRing& ring : rings)
    if (ring.area > 0.0 && (parts.empty() || ring.area >= min_area)) {
      parts.push_back (ring);
      outline.push_back ({ring.corners});
    }
  for (const SignedRing& hole : rings) {
    if (hole.area > -min_area)
      continue;
    // The smallest part around it; asking the largest one takes long.
    std::size_t around = parts.size();
    while (around > 1 && !isIn (hole, parts[around - 1]))
      --around;
    if (around > 0 && -hole.area < parts[around - 1].area)
      outline[around - 1].push_back (hole.corners);
  }
  constexpr double spacings_within = 0.3; // measured on simulated roofs and facades
  const double spacing = std::sqrt (areaOf (outline) / points);
  for (PlanarRings& part : outline)
    for (PlanarPoints& ring : part)
      ring = movedOut (ring, spacings_within * spacing);
  return outline;
}

} // namespace pcl_ops::apps

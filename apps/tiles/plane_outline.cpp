// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Boost 1.74 remarks in every build on a header it includes itself.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#undef BOOST_ALLOW_DEPRECATED_HEADERS

#include <boost/polygon/voronoi.hpp>

#include "exact_moments.h"
#include "plane_outline.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_ops::apps {

namespace {

using Square = std::array<std::int64_t, 2>;
using Diagram = boost::polygon::voronoi_diagram<double>;
using Vertex = Diagram::vertex_type;

struct Site {
  Square square{};
  std::int64_t u = 0, v = 0;
  OutlinePoint point;

  friend bool
  operator<(const Site& a, const Site& b)
  {
    return std::tie (a.square, a.u, a.v, a.point.place) <
           std::tie (b.square, b.u, b.v, b.point.place);
  }
};

/** \brief The points sorted by squares as wide as a cell, each place once. They are
 * seen along the axis next to the normal, so that all tiles see the same places: with
 * weights by which roofs of 45 degrees and walls between two axes are not on the edge
 * between both views. */
std::vector<Site>
sitesOf (const std::vector<OutlinePoint>& points,
         const Eigen::Vector3d& normal,
         double cell)
{
  const Eigen::Vector3d weights (1.3, 1.0, 1.8);
  Eigen::Index axis = 0;
  normal.cwiseAbs().cwiseProduct (weights).maxCoeff (&axis);
  auto u = static_cast<std::size_t> ((axis + 1) % 3);
  auto v = static_cast<std::size_t> ((axis + 2) % 3);
  if (normal[axis] < 0.0)
    std::swap (u, v);
  std::vector<Site> sites;
  sites.reserve (points.size());
  const auto square_of = [cell] (std::int64_t along) {
    return static_cast<std::int64_t> (std::floor (static_cast<double> (along) / cell));
  };
  for (const OutlinePoint& point : points) {
    const std::int64_t along_u = point.place[u], along_v = point.place[v];
    sites.push_back (
        {{square_of (along_u), square_of (along_v)}, along_u, along_v, point});
  }
  std::sort (sites.begin(), sites.end());
  const auto is_same = [] (const Site& a, const Site& b) {
    return a.u == b.u && a.v == b.v;
  };
  sites.erase (std::unique (sites.begin(), sites.end(), is_same), sites.end());
  return sites;
}

struct TakenSquare {
  Square square{};
  bool has_own = false, has_others = false;
  /** \brief An edge may be in it, or a triangle that another tile has as well. */
  bool stays_whole = false;
};

std::vector<TakenSquare>
squaresOf (const std::vector<Site>& sites)
{
  std::vector<TakenSquare> squares;
  for (const Site& site : sites) {
    if (squares.empty() || squares.back().square != site.square)
      squares.push_back ({site.square, false, false, false});
    (site.point.is_own ? squares.back().has_own : squares.back().has_others) = true;
  }
  return squares;
}

TakenSquare*
squareAt (const Square& square, std::vector<TakenSquare>& squares)
{
  const auto found = std::lower_bound (
      squares.begin(), squares.end(), square, [] (const auto& a, const Square& b) {
        return a.square < b;
      });
  return found != squares.end() && found->square == square ? &*found : nullptr;
}

/** \brief Calls visit (square) with what is taken, or nullptr, for those that are so
 * near. */
template <typename Visit>
void
forSquaresAround (const Square& square,
                  std::int64_t reach,
                  std::vector<TakenSquare>& squares,
                  Visit&& visit)
{
  for (std::int64_t du = -reach; du <= reach; ++du)
    for (std::int64_t dv = -reach; dv <= reach; ++dv)
      visit (squareAt ({square[0] + du, square[1] + dv}, squares));
}

/** \brief Finds the squares at the rim, and those near a border of tiles, where each
 * has triangles of the same points: one that is a point of the plane to one of the
 * tiles alone must not change which others are left. */
void
markWhole (std::vector<TakenSquare>& squares)
{
  // A triangle reaches three cells, and the circle around it no farther.
  constexpr std::int64_t reach_of_triangles = 4;
  for (TakenSquare& taken : squares) {
    bool is_at_border = taken.has_own && taken.has_others;
    forSquaresAround (taken.square, 1, squares, [&] (const TakenSquare* next) {
      taken.stays_whole = taken.stays_whole || next == nullptr;
      is_at_border =
          is_at_border || (next != nullptr && next->has_own != taken.has_own);
    });
    if (is_at_border)
      forSquaresAround (
          taken.square, reach_of_triangles, squares, [] (TakenSquare* near) {
            if (near != nullptr)
              near->stays_whole = true;
          });
  }
}

/** \brief Leaves one site of each square that need not stay whole. */
std::vector<Site>
thinned (const std::vector<Site>& sites, std::vector<TakenSquare>& squares)
{
  markWhole (squares);
  std::vector<Site> left;
  auto taken = squares.begin();
  for (const Site& site : sites) {
    const bool is_first = left.empty() || left.back().square != site.square;
    while (taken->square != site.square)
      ++taken;
    if (is_first || taken->stays_whole)
      left.push_back (site);
  }
  return left;
}

/** \brief The largest radius of a triangle [cells]: a circle of it has some hundred
 * points, whatever their density, in steps, so that neighboring tiles mostly agree. */
double
radiusFor (std::size_t sites, std::size_t squares)
{
  const double density = static_cast<double> (sites) / static_cast<double> (squares);
  constexpr double dense = 8.0, sparse = 2.0;
  return density >= dense ? 1.5 : density >= sparse ? 3.0 : 6.0;
}

/** \brief Those within the reach of the diagram's coordinates of the first one. */
std::vector<Site>
withinReach (std::vector<Site> sites)
{
  constexpr std::int64_t reach = 1 << 30;
  const Site first = sites.front();
  const auto is_beyond = [&] (const Site& site) {
    return std::abs (site.u - first.u) > reach || std::abs (site.v - first.v) > reach;
  };
  sites.erase (std::remove_if (sites.begin(), sites.end(), is_beyond), sites.end());
  return sites;
}

void
construct (const std::vector<Site>& sites, Diagram& diagram)
{
  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (const Site& site : sites)
    builder.insert_point (static_cast<std::int32_t> (site.u - sites.front().u),
                          static_cast<std::int32_t> (site.v - sites.front().v));
  builder.construct (&diagram);
}

/** \brief Whether the sites around a vertex of the diagram make a triangle, or a
 * polygon of sites on one circle, that is small enough and the tile's. */
bool
isKept (const Vertex& vertex, const std::vector<Site>& sites, double radius)
{
  const Site* first = nullptr;
  const auto* edge = vertex.incident_edge();
  do {
    const Site& site = sites[edge->cell()->source_index()];
    if (first == nullptr || std::tie (site.u, site.v) < std::tie (first->u, first->v))
      first = &site;
    edge = edge->rot_next();
  }
  while (edge != vertex.incident_edge());
  const double du = vertex.x() - static_cast<double> (first->u - sites.front().u);
  const double dv = vertex.y() - static_cast<double> (first->v - sites.front().v);
  return first->point.is_own && du * du + dv * dv <= radius * radius;
}

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

double
outlineUnit (double cell)
{
  constexpr double moments_units = 128.0;
  return moments_units * latticeFor (cell);
}

std::vector<OutlineEdge>
outlineEdges (const std::vector<OutlinePoint>& points,
              const Eigen::Vector3d& normal,
              double cell)
{
  if (points.empty())
    return {};
  std::vector<Site> sites = sitesOf (points, normal, cell);
  std::vector<TakenSquare> squares = squaresOf (sites);
  const double radius = cell * radiusFor (sites.size(), squares.size());
  sites = withinReach (thinned (sites, squares));
  Diagram diagram;
  construct (sites, diagram);
  constexpr std::size_t kept = 1;
  for (const Vertex& vertex : diagram.vertices())
    vertex.color (isKept (vertex, sites, radius) ? kept : 0);
  std::vector<OutlineEdge> edges;
  for (const auto& edge : diagram.edges()) {
    const Vertex *begin = edge.vertex0(), *end = edge.vertex1();
    const bool is_inside = begin != nullptr && begin->color() == kept;
    if (!is_inside || (end != nullptr && end->color() == kept))
      continue;
    // Around its beginning, the diagram's edge is between the site to its right and,
    // next to the left, the one to its left.
    edges.push_back ({sites[edge.twin()->cell()->source_index()].point.place,
                      sites[edge.cell()->source_index()].point.place});
  }
  return edges;
}

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

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Silences a note of Boost 1.74 on a deprecated header that it includes itself.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#undef BOOST_ALLOW_DEPRECATED_HEADERS

#include <boost/polygon/voronoi.hpp>

#include "exact_moments.h"
#include "plane_outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

BOOST_GEOMETRY_REGISTER_POINT_2D (Eigen::Vector2d, double, cs::cartesian, x(), y())

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

/** \brief Projects points along the coordinate axis nearest to the normal, so that all
 * tiles get the same places. Returns each place once, sorted by squares as wide as a
 * cell. Weights decide between two axes, else a roof of 45 degrees, or a wall between
 * two axes, could have one axis in a tile and another in the next. */
std::vector<Site>
sitesOf (const std::vector<OutlinePoint>& points,
         const Eigen::Vector3d& normal,
         double cell)
{
  const Eigen::Vector3d weights (1.3, 1.0, 1.8);
  Eigen::Index axis = 0;
  normal.cwiseAbs().cwiseProduct (weights).maxCoeff (&axis);
  Eigen::Index u = (axis + 1) % 3;
  Eigen::Index v = (axis + 2) % 3;
  if (normal[axis] < 0.0)
    std::swap (u, v);
  const auto square_of = [cell] (std::int64_t along) {
    return static_cast<std::int64_t> (std::floor (double (along) / cell));
  };
  std::vector<Site> sites;
  sites.reserve (points.size());
  for (const OutlinePoint& point : points) {
    const std::int64_t along_u = point.place[u];
    const std::int64_t along_v = point.place[v];
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
  bool has_own = false, has_others = false;
  /** \brief Its points are not thinned: an edge of the outline may be in it, or a
   * triangle that another tile has, too. */
  bool stays_whole = false;
};

using TakenSquares = std::map<Square, TakenSquare>;

TakenSquares
squaresOf (const std::vector<Site>& sites)
{
  TakenSquares squares;
  for (const Site& site : sites) {
    TakenSquare& taken = squares.try_emplace (squares.end(), site.square)->second;
    if (site.point.is_own)
      taken.has_own = true;
    else
      taken.has_others = true;
  }
  return squares;
}

/** \brief Calls visit (taken) for all squares up to \p reach squares away along u and
 * v, with nullptr for a square without points. */
template <typename Visit>
void
forSquaresAround (const Square& square,
                  std::int64_t reach,
                  TakenSquares& squares,
                  Visit&& visit)
{
  for (std::int64_t du = -reach; du <= reach; ++du)
    for (std::int64_t dv = -reach; dv <= reach; ++dv) {
      const auto found = squares.find ({square[0] + du, square[1] + dv});
      visit (found == squares.end() ? nullptr : &found->second);
    }
}

/** \brief Marks the squares that are not thinned: those at the rim of the plane, and
 * those near a border of tiles. There both tiles must have the same triangles: a point
 * that only one tile has on the plane must not change which others are left. */
void
markWhole (TakenSquares& squares)
{
  // The circumcircle of a triangle of a dense plane (radiusFor) is at most three cells
  // wide. Sparser planes have hardly a square to thin.
  constexpr std::int64_t reach_of_triangles = 4;
  for (auto& [square, taken] : squares) {
    bool is_at_rim = false;
    bool is_at_border = taken.has_own && taken.has_others;
    forSquaresAround (square, 1, squares, [&, own = taken.has_own] (auto* next) {
      is_at_rim = is_at_rim || next == nullptr;
      is_at_border = is_at_border || (next != nullptr && next->has_own != own);
    });
    taken.stays_whole = taken.stays_whole || is_at_rim;
    if (is_at_border)
      forSquaresAround (square, reach_of_triangles, squares, [] (TakenSquare* near) {
        if (near != nullptr)
          near->stays_whole = true;
      });
  }
}

/** \brief Keeps only the first site of each square that need not stay whole. */
std::vector<Site>
thinned (const std::vector<Site>& sites, TakenSquares& squares)
{
  markWhole (squares);
  std::vector<Site> left;
  auto taken = squares.begin();
  for (const Site& site : sites) {
    const bool is_first = left.empty() || left.back().square != site.square;
    while (taken->first != site.square)
      ++taken;
    if (is_first || taken->second.stays_whole)
      left.push_back (site);
  }
  return left;
}

/** \brief The largest circumradius of a triangle [cells]: its circle has some hundred
 * points at any density. It changes in steps, so that tiles mostly use the same. */
double
radiusFor (std::size_t sites, std::size_t squares)
{
  const double density = double (sites) / double (squares);
  constexpr double dense = 8.0;
  constexpr double sparse = 2.0;
  return density >= dense ? 1.5 : density >= sparse ? 3.0 : 6.0;
}

/** \brief Whether the sites around a Voronoi vertex (a Delaunay triangle, or a polygon
 * of sites on one circle) have a circumradius of at most \p radius [lattice places] and
 * a first site that is the tile's own. */
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
  const double du = vertex.x() - double (first->u - sites.front().u);
  const double dv = vertex.y() - double (first->v - sites.front().v);
  return first->point.is_own && du * du + dv * dv <= radius * radius;
}

/** \brief A corner of the outline, and the ends of its edges that no ring has yet. */
struct Corner {
  Eigen::Vector2d point;
  std::vector<Corner*> next;
  bool is_on_path = false;

  /** \brief Removes an edge from the corner and returns its end. Of several edges it
   * takes the one along the same part of the plane: the next one clockwise from the
   * direction to \p previous, unless that is nullptr. */
  Corner*
  takeNext (const Corner* previous)
  {
    const auto angle_of = [this] (const Corner* other) {
      const Eigen::Vector2d way = other->point - point;
      return std::atan2 (way.y(), way.x());
    };
    const auto turn_to = [&] (const Corner* other) {
      const double turn = angle_of (previous) - angle_of (other);
      return turn <= 0.0 ? turn + 2.0 * M_PI : turn;
    };
    auto best = next.begin();
    if (previous != nullptr && next.size() > 1)
      best = std::min_element (next.begin(), next.end(), [&] (auto* a, auto* b) {
        return turn_to (a) < turn_to (b);
      });
    Corner* const result = *best;
    next.erase (best);
    return result;
  }
};

/** \brief Follows edges until a corner has none left, and takes a ring off the path
 * whenever it comes back to one of its corners. */
void
follow (Corner* corner, std::vector<PlanarPoints>& rings)
{
  std::vector<Corner*> path;
  for (;;) {
    if (corner->is_on_path) {
      const auto first = std::find (path.rbegin(), path.rend(), corner).base() - 1;
      rings.emplace_back();
      for (auto on_ring = first; on_ring != path.end(); ++on_ring) {
        rings.back().push_back ((*on_ring)->point);
        (*on_ring)->is_on_path = false;
      }
      path.erase (first, path.end());
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

/** \brief Rings along the edges that are left after opposite ones cancel. A ring
 * visits no corner twice. */
std::vector<PlanarPoints>
ringsAlong (const std::vector<OutlineEdge>& edges, const PlaneFrame& frame, double unit)
{
  // How many more edges go from one end to the other than back.
  std::map<std::pair<LatticePlace, LatticePlace>, int> surplus;
  for (const OutlineEdge& edge : edges)
    surplus[std::minmax (edge.from, edge.to)] += edge.from < edge.to ? 1 : -1;
  std::map<LatticePlace, Corner> corners;
  for (const auto& [ends, count] : surplus)
    for (int i = 0; i < std::abs (count); ++i) {
      Corner& first = corners[ends.first];
      Corner& second = corners[ends.second];
      if (count > 0)
        first.next.push_back (&second);
      else
        second.next.push_back (&first);
    }
  for (auto& [place, corner] : corners)
    corner.point = frame.toPlane (
        unit * Eigen::Map<const Eigen::Matrix<std::int64_t, 3, 1>> (place.data())
                   .cast<double>());
  std::vector<PlanarPoints> rings;
  for (auto& [place, corner] : corners)
    while (!corner.next.empty())
      follow (&corner, rings);
  return rings;
}

/** \brief Removes spikes, where a ring goes to a corner and straight back. They arise
 * where two tiles round a point to different lattice places. */
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
  // The ring is closed: its last or first corner may be the tip of a spike.
  while (left.size() > 2 && (left[left.size() - 2] - left.front()).norm() < near)
    left.resize (left.size() - 2);
  while (left.size() > 2 && (left.back() - left[1]).norm() < near)
    left.erase (left.begin(), left.begin() + 2);
  return left;
}

/** \brief Moves each corner to the right of its sides, along their bisector: a part
 * grows, a hole shrinks. \param[in] distance [m] */
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

namespace geometry = boost::geometry;

/** \brief A part of the plane, counter-clockwise, or a hole, clockwise. */
struct SignedRing {
  geometry::model::ring<Eigen::Vector2d, false, false> corners;
  geometry::model::box<Eigen::Vector2d> box;
  double area = 0.0;

  explicit SignedRing (const PlanarPoints& ring) : corners (ring.begin(), ring.end())
  {
    geometry::envelope (corners, box);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
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

/** \brief The rings without spikes, by falling absolute area. */
std::vector<SignedRing>
signedRings (const std::vector<PlanarPoints>& traced, double unit)
{
  std::vector<SignedRing> rings;
  for (const PlanarPoints& with_spikes : traced)
    if (const PlanarPoints ring = withoutSpikes (with_spikes, unit); ring.size() >= 3)
      rings.emplace_back (ring);
  std::stable_sort (rings.begin(), rings.end(), [] (const auto& a, const auto& b) {
    return std::abs (a.area) > std::abs (b.area);
  });
  return rings;
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
  TakenSquares squares = squaresOf (sites);
  const double radius = cell * radiusFor (sites.size(), squares.size());
  sites = thinned (sites, squares);
  const std::int64_t u = sites.front().u;
  const std::int64_t v = sites.front().v;
  const auto is_beyond = [u, v] (const Site& site) {
    constexpr std::int64_t reach = 1 << 30; // of the diagram's coordinates
    return std::abs (site.u - u) > reach || std::abs (site.v - v) > reach;
  };
  sites.erase (std::remove_if (sites.begin(), sites.end(), is_beyond), sites.end());
  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (const Site& site : sites)
    builder.insert_point (site.u - u, site.v - v);
  Diagram diagram;
  builder.construct (&diagram);
  constexpr std::size_t kept = 1;
  for (const Vertex& vertex : diagram.vertices())
    vertex.color (isKept (vertex, sites, radius) ? kept : 0);
  std::vector<OutlineEdge> edges;
  for (const auto& edge : diagram.edges()) {
    const Vertex* begin = edge.vertex0();
    const Vertex* end = edge.vertex1();
    const bool is_inside = begin != nullptr && begin->color() == kept;
    if (!is_inside || (end != nullptr && end->color() == kept))
      continue;
    // This Voronoi edge crosses an edge of the outline, which goes from the site on its
    // right to the site on its left.
    edges.push_back ({sites[edge.twin()->cell()->source_index()].point.place,
                      sites[edge.cell()->source_index()].point.place});
  }
  return edges;
}

namespace {

/** \return 1 + position of the smallest part around a hole; 0 if there are no parts. If
 * no other part is around the hole, the largest is returned untested, as that is slow.
 * \param[in] parts by falling area */
std::size_t
partAround (const SignedRing& hole, const std::vector<SignedRing>& parts)
{
  std::size_t around = parts.size();
  while (around > 1 && !hole.isIn (parts[around - 1]))
    --around;
  return around;
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
  double area = 0.0;
  for (const SignedRing& ring : rings) {
    const bool is_part = ring.area > 0.0 && (parts.empty() || ring.area >= min_area);
    if (!is_part)
      continue;
    parts.push_back (ring);
    outline.push_back ({ring.corners});
    area += ring.area;
  }
  for (const SignedRing& hole : rings) {
    if (hole.area > -min_area)
      continue;
    const std::size_t around = partAround (hole, parts);
    if (around > 0 && -hole.area < parts[around - 1].area) {
      outline[around - 1].push_back (hole.corners);
      area += hole.area;
    }
  }
  constexpr double spacings_within = 0.3; // measured on simulated roofs and facades
  const double spacing = std::sqrt (area / points);
  for (PlanarRings& part : outline)
    for (PlanarPoints& ring : part)
      ring = movedOut (ring, spacings_within * spacing);
  return outline;
}

} // namespace pcl_ops::apps

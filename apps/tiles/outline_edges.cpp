// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outline_edges.h"

#include <boost/polygon/voronoi.hpp>

#include "exact_moments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace pcl_ops::apps {

namespace {

/** \brief Number of a square along u and along v, 0 for the one that begins at zero. A
 * square is as wide as a cell. */
using Square = std::array<std::int64_t, 2>;
using Diagram = boost::polygon::voronoi_diagram<double>;
using VoronoiVertex = Diagram::vertex_type;

/** \brief A point projected along a coordinate axis: a site of the Voronoi diagram. */
struct Site {
  Square square{};
  /** \brief Coordinates along the two other axes [unit of the lattice]. */
  std::int64_t u = 0, v = 0;
  OutlinePoint point;

  friend bool
  operator<(const Site& a, const Site& b)
  {
    return std::tie (a.square, a.u, a.v, a.point.position) <
           std::tie (b.square, b.u, b.v, b.point.position);
  }
};

/** \brief Projects points along a coordinate axis near the normal, so that all tiles
 * get the same sites. Returns the sites without duplicates, sorted by squares.
 *
 * It is the axis of the largest weighted component of the normal. Without weights the
 * axes of a roof of 45 degrees, or of a wall between two axes, could differ between
 * tiles. With the weights they could differ for slopes of 54 degrees along x and of 61
 * along y, and for walls at 52 degrees to the y axis, which are rarer. */
std::vector<Site>
sitesOf (const std::vector<OutlinePoint>& points,
         const Eigen::Vector3d& normal,
         double cell_edge)
{
  const Eigen::Vector3d weights (1.3, 1.0, 1.8); // along x, y and z
  Eigen::Index axis = 0;
  normal.cwiseAbs().cwiseProduct (weights).maxCoeff (&axis);
  Eigen::Index u = (axis + 1) % 3;
  Eigen::Index v = (axis + 2) % 3;
  // Seen from the side that the normal points to, v is counter-clockwise of u.
  if (normal[axis] < 0.0)
    std::swap (u, v);
  const auto square_number = [cell_edge] (std::int64_t coordinate) {
    return static_cast<std::int64_t> (std::floor (double (coordinate) / cell_edge));
  };
  std::vector<Site> sites;
  sites.reserve (points.size());
  for (const OutlinePoint& point : points) {
    const std::int64_t along_u = point.position[u];
    const std::int64_t along_v = point.position[v];
    sites.push_back (
        {{square_number (along_u), square_number (along_v)}, along_u, along_v, point});
  }
  std::sort (sites.begin(), sites.end());
  const auto coincide = [] (const Site& one, const Site& other) {
    return one.u == other.u && one.v == other.v;
  };
  sites.erase (std::unique (sites.begin(), sites.end(), coincide), sites.end());
  return sites;
}

/** \brief What sites a square with sites has. */
struct SquareState {
  /** \brief Whether it has sites in the tile, and sites in its halo. */
  bool has_own = false, has_halo = false;
  /** \brief Whether its sites are not thinned: an edge of the outline may be in it, or
   * a triangle that another tile has, too. */
  bool keeps_all = false;
};

using OccupiedSquares = std::map<Square, SquareState>;

/** \brief Returns the squares that have sites.
 * \param[in] sites sorted by squares */
OccupiedSquares
squaresOf (const std::vector<Site>& sites)
{
  OccupiedSquares squares;
  for (const Site& site : sites) {
    SquareState& state = squares.try_emplace (squares.end(), site.square)->second;
    if (site.point.is_own)
      state.has_own = true;
    else
      state.has_halo = true;
  }
  return squares;
}

/** \brief Calls visit (SquareState*) for a square and all squares up to \p reach
 * squares away along u and v, with nullptr for a square without sites. */
template <typename Visit>
void
forSquaresAround (const Square& square,
                  std::int64_t reach,
                  OccupiedSquares& squares,
                  Visit&& visit)
{
  for (std::int64_t du = -reach; du <= reach; ++du)
    for (std::int64_t dv = -reach; dv <= reach; ++dv) {
      const auto found = squares.find ({square[0] + du, square[1] + dv});
      visit (found == squares.end() ? nullptr : &found->second);
    }
}

/** \brief Sets SquareState::keeps_all of squares at the rim of the plane, which have a
 * neighbor without sites, and of squares near a border of tiles. There both tiles must
 * have the same triangles. As a point may be on the plane in one tile only, it must not
 * decide which other sites are kept. */
void
markUnthinned (OccupiedSquares& squares)
{
  // The circumcircle of a triangle of a dense plane is at most three cells wide
  // (maxCircumradius); one more is a margin. Sparser planes have wider circles, but
  // fewer points to thin.
  constexpr std::int64_t reach_of_triangles = 4;
  for (auto& [square, state] : squares) {
    bool is_at_rim = false;
    bool is_at_border = state.has_own && state.has_halo;
    const auto note_neighbor = [&, has_own = state.has_own] (const SquareState* next) {
      is_at_rim = is_at_rim || next == nullptr;
      is_at_border = is_at_border || (next != nullptr && next->has_own != has_own);
    };
    forSquaresAround (square, 1, squares, note_neighbor);
    state.keeps_all = state.keeps_all || is_at_rim;
    if (is_at_border)
      forSquaresAround (square, reach_of_triangles, squares, [] (SquareState* near) {
        if (near != nullptr)
          near->keeps_all = true;
      });
  }
}

/** \brief Returns all sites of squares that are not thinned, and the first site of each
 * other square.
 * \param[in] sites sorted by squares
 * \param[in,out] squares get SquareState::keeps_all */
std::vector<Site>
thinned (const std::vector<Site>& sites, OccupiedSquares& squares)
{
  markUnthinned (squares);
  std::vector<Site> kept;
  auto square = squares.begin();
  for (const Site& site : sites) {
    const bool is_first = kept.empty() || kept.back().square != site.square;
    while (square->first != site.square)
      ++square;
    if (is_first || square->second.keeps_all)
      kept.push_back (site);
  }
  return kept;
}

/** \brief Returns the largest circumradius of a triangle [edges of a cell], by the
 * density of the sites in a tile: a circle of this radius has some 60 to 230 sites if a
 * square has 0.5 to 32. The radius changes in steps, so that tiles mostly use the same
 * one. */
double
maxCircumradius (std::size_t sites, std::size_t squares)
{
  const double sites_per_square = double (sites) / double (squares);
  constexpr double min_of_dense = 8.0;  // [sites per square]
  constexpr double min_of_sparse = 2.0; // [sites per square]
  return sites_per_square >= min_of_dense    ? 1.5
         : sites_per_square >= min_of_sparse ? 3.0
                                             : 6.0;
}

/** \brief Removes sites so far from the first one that their coordinates relative to it
 * do not fit into the 32 bits of the diagram. */
void
removeFarSites (std::vector<Site>& sites)
{
  const auto is_too_far = [u = sites.front().u,
                           v = sites.front().v] (const Site& site) {
    constexpr std::int64_t max_coordinate = 1 << 30;
    return std::abs (site.u - u) > max_coordinate ||
           std::abs (site.v - v) > max_coordinate;
  };
  sites.erase (std::remove_if (sites.begin(), sites.end(), is_too_far), sites.end());
}

/** \brief Makes the Voronoi diagram of the sites, in coordinates relative to the first
 * one. */
void
fillDiagram (const std::vector<Site>& sites, Diagram& diagram)
{
  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (const Site& site : sites)
    builder.insert_point (site.u - sites.front().u, site.v - sites.front().v);
  builder.construct (&diagram);
}

/** \brief Whether the Delaunay triangle of a Voronoi vertex is part of the alpha shape
 * and belongs to this tile: its circumradius is at most \p max_radius, and its first
 * site, by u and then v, is the tile's own. Four and more sites on one circle are the
 * corners of one polygon, which counts as a triangle.
 * \param[in] max_radius [spacing of the lattice] */
bool
isKept (const VoronoiVertex& vertex, const std::vector<Site>& sites, double max_radius)
{
  const Site* first = nullptr;
  const Diagram::edge_type* edge = vertex.incident_edge();
  do {
    const Site& site = sites[edge->cell()->source_index()];
    if (first == nullptr || std::tie (site.u, site.v) < std::tie (first->u, first->v))
      first = &site;
    edge = edge->rot_next();
  }
  while (edge != vertex.incident_edge());
  // The vertex is the circumcenter; its coordinates are relative to the first of all
  // sites (fillDiagram).
  const double du = vertex.x() - double (first->u - sites.front().u);
  const double dv = vertex.y() - double (first->v - sites.front().v);
  return first->point.is_own && du * du + dv * dv <= max_radius * max_radius;
}

} // namespace

double
outlineUnit (double cell_edge)
{
  // A power of two, as ExactMoments::unit. Larger units would make the outline coarse,
  // smaller ones the reach of the diagram short (removeFarSites).
  constexpr double in_moments_units = 128.0;
  return in_moments_units * momentsUnit (cell_edge);
}

std::vector<OutlineEdge>
outlineEdges (const std::vector<OutlinePoint>& points,
              const Eigen::Vector3d& normal,
              double cell_edge)
{
  if (points.empty())
    return {};
  std::vector<Site> sites = sitesOf (points, normal, cell_edge);
  OccupiedSquares squares = squaresOf (sites);
  const double max_radius = cell_edge * maxCircumradius (sites.size(), squares.size());
  sites = thinned (sites, squares);
  removeFarSites (sites);
  Diagram diagram;
  fillDiagram (sites, diagram);
  constexpr std::size_t kept = 1;
  for (const VoronoiVertex& vertex : diagram.vertices())
    vertex.color (isKept (vertex, sites, max_radius) ? kept : 0);
  std::vector<OutlineEdge> edges;
  for (const Diagram::edge_type& edge : diagram.edges()) {
    const VoronoiVertex* begin = edge.vertex0();
    const VoronoiVertex* end = edge.vertex1();
    const bool is_inside = begin != nullptr && begin->color() == kept;
    if (!is_inside || (end != nullptr && end->color() == kept))
      continue;
    // This Voronoi edge crosses an edge of the outline, which goes from the site on its
    // right to the site on its left.
    edges.push_back ({sites[edge.twin()->cell()->source_index()].point.position,
                      sites[edge.cell()->source_index()].point.position});
  }
  return edges;
}

} // namespace pcl_ops::apps

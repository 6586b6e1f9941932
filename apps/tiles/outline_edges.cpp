// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outline_edges.h"

#include <boost/polygon/voronoi.hpp>

#include "exact_moments.h"

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

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "alpha_shape.h"
#include "geometry/planar_area.h"
#include "planes/planar_ring.h"
#include <pcl_ops/surface/concave_hull.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace pcl_ops {
using namespace internal;
namespace {

namespace geometry = boost::geometry;

/** \brief The points inside an outline or on it. */
PlanarPoints
pointsWithin (const PlanarPoints& outline, const PlanarPoints& points)
{
  const Ring ring (outline.begin(), outline.end());
  PlanarPoints within;
  for (const Eigen::Vector2d& point : points)
    if (geometry::covered_by (point, ring))
      within.push_back (point);
  return within;
}

/** \brief Points, each with the number of points that it stands for. */
struct WeightedPoints {
  PlanarPoints points;
  std::vector<std::size_t> weights;
};

/** \brief A square cell of a grid, by column and row. */
using Cell = std::pair<std::int64_t, std::int64_t>;
/** \brief The indices of the points in each cell. */
using Cells = std::map<Cell, std::vector<std::size_t>>;

/** \brief Thins the points far from the rim: keeps one point of each square cell whose
 * eight neighbor cells all have points, and all points of the other cells.
 * \param[in] edge of a cell, in the unit of the points */
WeightedPoints
thinnedInside (const PlanarPoints& points, double edge)
{
  Cells cells;
  for (std::size_t i = 0; i < points.size(); ++i)
    cells[{std::llround (points[i].x() / edge), std::llround (points[i].y() / edge)}]
        .push_back (i);
  WeightedPoints thinned;
  for (const auto& [cell, members] : cells) {
    const auto [column, row] = cell;
    bool is_inside = true;
    for (const std::int64_t dx : {-1, 0, 1})
      for (const std::int64_t dy : {-1, 0, 1})
        is_inside &= cells.count ({column + dx, row + dy}) > 0;
    const std::size_t kept = is_inside ? 1 : members.size();
    for (std::size_t m = 0; m < kept; ++m) {
      thinned.points.push_back (points[members[m]]);
      thinned.weights.push_back (is_inside ? members.size() : 1);
    }
  }
  return thinned;
}

/** \brief The sum of the weights of the points inside a ring or on it. */
std::size_t
weightWithin (const Ring& ring, const WeightedPoints& points)
{
  std::size_t weight = 0;
  for (std::size_t i = 0; i < points.points.size(); ++i)
    if (geometry::covered_by (points.points[i], ring))
      weight += points.weights[i];
  return weight;
}

/** \brief All rings of the alpha shape, counter-clockwise, by descending area. */
std::vector<Ring>
ringsOf (const PlanarPoints& points, double alpha)
{
  std::vector<Ring> rings;
  for (const PlanarPoints& corners : alphaShapeRings (points, alpha)) {
    rings.emplace_back (corners.begin(), corners.end());
    geometry::correct (rings.back());
  }
  std::stable_sort (rings.begin(), rings.end(), [] (const Ring& a, const Ring& b) {
    return geometry::area (a) > geometry::area (b);
  });
  return rings;
}

/** \brief The corners of a ring without those within \p tolerance of a line between
 * others. */
Ring
cornersOf (const Ring& ring, double tolerance)
{
  Ring corners;
  geometry::simplify (ring, corners, tolerance);
  geometry::correct (corners);
  return corners;
}

/** \brief Moves the corners of a hole that lie on another ring into the hole, by a
 * millionth of the sides beside them: meshes need rings that do not touch.
 * \param[in] rings all rings, counter-clockwise
 * \param[in] hole index of the hole
 * \return the corners of the hole, counter-clockwise */
PlanarPoints
detached (const std::vector<Ring>& rings, std::size_t hole)
{
  constexpr double share_of_sides = 1e-6;
  const PlanarPoints& corners = rings[hole];
  PlanarPoints moved = corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    bool touches = false;
    for (std::size_t other = 0; other < rings.size(); ++other)
      touches |= other != hole && geometry::covered_by (corners[i], rings[other]) &&
                 !geometry::within (corners[i], rings[other]);
    if (!touches)
      continue;
    const Eigen::Vector2d to_last =
        corners[(i + corners.size() - 1) % corners.size()] - corners[i];
    const Eigen::Vector2d to_next = corners[(i + 1) % corners.size()] - corners[i];
    // Where the hole is wider than half a turn, it is opposite to its neighbor corners.
    const double turn = to_next.x() * to_last.y() - to_next.y() * to_last.x();
    const double inwards = turn > 0.0 ? 1.0 : -1.0;
    moved[i] += share_of_sides * inwards * 0.5 * (to_last + to_next);
  }
  return moved;
}

/** \brief The first ring as outline, and the rings inside it as its holes, clockwise;
 * rings inside a hole are left out.
 * \param[in] rings counter-clockwise, by descending area; at least one
 * \param[in] min_hole_area in the squared unit of the points
 * \param[in] tolerance of the simplification of rings */
PlanarRings
withHoles (const std::vector<Ring>& rings, double min_hole_area, double tolerance)
{
  std::vector<Ring> holes;
  for (auto ring = rings.begin() + 1; ring != rings.end(); ++ring) {
    const auto liesWithin = [&] (const Ring& other) {
      return geometry::covered_by (*ring, other);
    };
    const bool is_hole = geometry::area (*ring) >= min_hole_area &&
                         geometry::is_valid (*ring) && liesWithin (rings.front()) &&
                         std::none_of (holes.begin(), holes.end(), liesWithin);
    if (is_hole)
      holes.push_back (*ring);
  }
  std::vector<Ring> simple = {cornersOf (rings.front(), tolerance)};
  for (const Ring& hole : holes)
    simple.push_back (cornersOf (hole, tolerance));
  PlanarRings outline = {simple.front()};
  for (std::size_t hole = 1; hole < simple.size(); ++hole) {
    outline.push_back (detached (simple, hole));
    std::reverse (outline.back().begin(), outline.back().end());
  }
  return outline;
}

/** \brief Number of distinct points: repeated points, as of rounded coordinates, tell
 * nothing about the spacing.
 * \param[in] points sorted, so that equal points follow each other */
std::size_t
countDistinctPoints (PlanarPoints points)
{
  return std::unique (points.begin(), points.end()) - points.begin();
}

PlanarPoints
scaled (double factor, PlanarPoints points)
{
  for (Eigen::Vector2d& point : points)
    point *= factor;
  return points;
}

/** \brief Largest share of all points that the convex hull leaves outside as strays:
 * half of what may be outside in the end. */
constexpr double max_outside_convex = 0.005;

/** \brief Smallest share of all points that an outline must have inside. */
constexpr double min_inside = 0.99;

/** \brief The alpha that is tried first, in units of the spacing of the points. This
 * number and the next ones are chosen by hand, if no reason stands beside them. */
constexpr double spacings_per_alpha = 6.0;

/** \brief Number of cells along a length of alpha when points are thinned. */
constexpr double cells_per_alpha = 2.0;

/** \brief Smallest edge of a cell. Scaled coordinates are 10^6 or less, so that the
 * numbers of cells fit into 64 bits whatever alpha is given. */
constexpr double min_edge_of_cell = 1e-9;

/** \brief While the outline has too few points inside, alpha is multiplied by
 * growth_of_alpha; after max_attempts outlines the convex hull is taken instead. */
constexpr double growth_of_alpha = 1.5;
constexpr int max_attempts = 8;

/** \brief A corner is left out if it is so near to a line between other corners, in
 * units of the spacing of the points. */
constexpr double spacings_from_line = 1e-3;

/** \brief The concave outline of points that were sorted, and scaled by \ref unitScale.
 * \param[in] alpha in the unit of the scaled points; if it is not above 0, the spacing
 * of the points determines it
 * \return empty if the points span no area */
PlanarRings
outlineAround (const PlanarPoints& points, double alpha)
{
  const PlanarPoints convex = convexHull (points, max_outside_convex);
  if (convex.empty())
    return {};
  const auto count = static_cast<double> (points.size());
  const PlanarPoints inside = pointsWithin (convex, points);
  const double spacing =
      std::sqrt (areaOf (convex) / static_cast<double> (countDistinctPoints (inside)));
  double tried_alpha = alpha > 0.0 ? alpha : spacings_per_alpha * spacing;
  const WeightedPoints thinned = thinnedInside (
      inside, std::max (tried_alpha / cells_per_alpha, min_edge_of_cell));
  const auto hasEnoughInside = [&] (const Ring& ring) {
    return static_cast<double> (weightWithin (ring, thinned)) >= min_inside * count;
  };
  for (int attempt = 0; attempt < max_attempts; ++attempt) {
    const std::vector<Ring> rings = ringsOf (thinned.points, tried_alpha);
    if (!rings.empty() && geometry::is_valid (rings.front()) &&
        hasEnoughInside (rings.front()))
      return withHoles (rings, tried_alpha * tried_alpha, spacings_from_line * spacing);
    tried_alpha *= growth_of_alpha;
  }
  return {convex};
}

} // namespace

PlanarRings
concaveOutline (const PlanarPoints& points, double alpha)
{
  PlanarPoints finite = finiteOf (points);
  // Sort them, so that the outline does not depend on the order of the points.
  std::sort (finite.begin(), finite.end(), [] (const auto& a, const auto& b) {
    return std::make_pair (a.x(), a.y()) < std::make_pair (b.x(), b.y());
  });
  const double scale = unitScale (finite);
  PlanarRings rings = outlineAround (scaled (scale, std::move (finite)), scale * alpha);
  for (PlanarPoints& ring : rings)
    ring = scaled (1.0 / scale, std::move (ring));
  return rings;
}

PlaneExtent
concavePlaneExtent (const CloudView& cloud, const PlaneSegment& plane, double alpha)
{
  const PlaneFrame frame (plane.centroid, plane.normal);
  const PlanarPoints points = pointsOnPlane (cloud, plane, frame);
  return extentOf (concaveOutline (points, alpha), points, frame);
}

} // namespace pcl_ops

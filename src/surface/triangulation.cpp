// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/planar_area.h"
#include <pcl_ops/surface/triangulation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl_ops {
namespace {

using namespace internal;

/** \brief A counter-clockwise ring (holes, until they are joined to it: clockwise), by
 * the indices of its corners in a list of corners. In this file a position is an index
 * into the ring itself. */
using CornerIndices = std::vector<std::size_t>;

/** \brief Where a ray meets a ring: a side, by the position of its first corner in the
 * ring, and the x coordinate of the intersection. */
struct Intersection {
  std::size_t side = 0;
  double x = std::numeric_limits<double>::infinity();
};

/** \brief Where a ray to the right, along +x, first meets a ring around its start. */
Intersection
firstIntersection (const Eigen::Vector2d& from,
                   const CornerIndices& ring,
                   const PlanarPoints& corners)
{
  Intersection nearest;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    // The ring is counter-clockwise: a side where the ray leaves the ring runs upwards.
    const Eigen::Vector2d& low = corners[ring[i]];
    const Eigen::Vector2d& high = corners[ring[(i + 1) % ring.size()]];
    if (!(low.y() <= from.y() && high.y() > from.y()))
      continue;
    const double share_of_side = (from.y() - low.y()) / (high.y() - low.y());
    const double x = low.x() + share_of_side * (high.x() - low.x());
    if (x >= from.x() && x < nearest.x)
      nearest = {i, x};
  }
  return nearest;
}

/** \brief Whether the segment from a corner of a ring to a point starts inside the ring
 * or along one of its sides. */
bool
leadsInside (const CornerIndices& ring,
             std::size_t position,
             const Eigen::Vector2d& to,
             const PlanarPoints& corners)
{
  const Eigen::Vector2d& corner = corners[ring[position]];
  const Eigen::Vector2d& next = corners[ring[(position + 1) % ring.size()]];
  const Eigen::Vector2d& previous =
      corners[ring[(position + ring.size() - 1) % ring.size()]];
  const bool is_left_of_next_side = twiceTheArea (corner, next, to) >= 0.0;
  const bool is_left_of_previous_side = twiceTheArea (corner, previous, to) <= 0.0;
  const bool is_convex = twiceTheArea (previous, corner, next) >= 0.0;
  return is_convex ? is_left_of_next_side && is_left_of_previous_side
                   : is_left_of_next_side || is_left_of_previous_side;
}

/** \brief The position of a corner of the ring that is visible from a point inside. A
 * ray to the right hits a side of the ring. The end of this side with the larger x is
 * visible, unless corners lie in the triangle of the point, the hit and this end: then
 * the corner at the smallest angle to the ray is visible. */
std::size_t
visibleFrom (const Eigen::Vector2d& from,
             const CornerIndices& ring,
             const PlanarPoints& corners)
{
  const Intersection hit = firstIntersection (from, ring, corners);
  const Eigen::Vector2d hit_point (hit.x, from.y());
  const std::size_t next = (hit.side + 1) % ring.size();
  std::size_t visible =
      corners[ring[hit.side]].x() > corners[ring[next]].x() ? hit.side : next;
  const Eigen::Vector2d& end = corners[ring[visible]];
  double smallest_slope = std::numeric_limits<double>::infinity();
  // The ring repeats the ends of bridges. Of the positions of one corner only the one
  // whose sides enclose the segment to the point may get the bridge: end is looked for
  // again, too.
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& corner = corners[ring[i]];
    const Eigen::Vector2d offset = corner - from;
    const double slope = std::abs (offset.y()) / offset.x();
    const bool is_candidate = corner == end || isWithin (corner, from, hit_point, end);
    if (!is_candidate || !(offset.x() > 0.0) || !leadsInside (ring, i, from, corners))
      continue;
    const bool is_nearer =
        slope == smallest_slope && offset.x() < (corners[ring[visible]] - from).x();
    if (slope < smallest_slope || is_nearer) {
      smallest_slope = slope;
      visible = i;
    }
  }
  return visible;
}

/** \brief Joins an outline and its holes to one ring, in which a bridge leads to each
 * hole and back (Eberly, Triangulation by ear clipping, 2002, section 3).
 * \param[in] rings the outline, then its holes; no ring touches another one
 * \param[in] corners of all rings, ring after ring
 * \return indices of the corners; the ends of bridges are repeated */
CornerIndices
joinByBridges (const PlanarRings& rings, const PlanarPoints& corners)
{
  CornerIndices ring (rings.front().size());
  std::iota (ring.begin(), ring.end(), 0);
  std::vector<CornerIndices> holes;
  std::size_t first_corner = ring.size(); // of the next hole
  const auto hasSmallerX = [&] (std::size_t a, std::size_t b) {
    return corners[a].x() < corners[b].x();
  };
  for (std::size_t r = 1; r < rings.size(); ++r) {
    CornerIndices hole (rings[r].size());
    std::iota (hole.begin(), hole.end(), first_corner);
    first_corner += rings[r].size();
    // Let the list of the hole start at its rightmost corner, where the bridge begins.
    std::rotate (hole.begin(),
                 std::max_element (hole.begin(), hole.end(), hasSmallerX),
                 hole.end());
    holes.push_back (hole);
  }
  // Join holes from right to left: so a bridge crosses no hole that is not yet part of
  // the ring.
  std::stable_sort (holes.begin(), holes.end(), [&] (const auto& a, const auto& b) {
    return hasSmallerX (b.front(), a.front());
  });
  for (CornerIndices& hole : holes) {
    const std::size_t visible = visibleFrom (corners[hole.front()], ring, corners);
    hole.push_back (hole.front());
    hole.push_back (ring[visible]);
    ring.insert (ring.begin() + visible + 1, hole.begin(), hole.end());
  }
  return ring;
}

/** \brief The triangle of a corner and its two neighbors in the ring. */
Triangle
triangleAt (const CornerIndices& ring, std::size_t position)
{
  const std::size_t size = ring.size();
  return {
      ring[(position + size - 1) % size], ring[position], ring[(position + 1) % size]};
}

/** \brief Whether the middle one of three successive corners of the ring is convex, and
 * their triangle contains no other corner. */
bool
isEar (const Triangle& triangle, const CornerIndices& ring, const PlanarPoints& corners)
{
  const Eigen::Vector2d& a = corners[triangle[0]];
  const Eigen::Vector2d& b = corners[triangle[1]];
  const Eigen::Vector2d& c = corners[triangle[2]];
  if (!(twiceTheArea (a, b, c) > 0.0))
    return false;
  return std::none_of (ring.begin(), ring.end(), [&] (std::size_t other) {
    const Eigen::Vector2d& corner = corners[other];
    // Corners with a bridge are repeated: compare positions, not indices.
    return corner != a && corner != b && corner != c && isWithin (corner, a, b, c);
  });
}

/** \brief The first position in the ring whose triangle passes a test, searched once
 * around the ring from \p from on; nothing if no triangle passes. */
template <typename Test>
std::optional<std::size_t>
nextPosition (const CornerIndices& ring, std::size_t from, Test&& passes)
{
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t position = (from + i) % ring.size();
    if (passes (triangleAt (ring, position)))
      return position;
  }
  return {};
}

/** \brief Cuts a ring into triangles by clipping its ears, convex corners whose
 * triangle has no other corner in it (Meisters, Polygons have ears, 1975). The ring may
 * touch itself, as a ring with bridges does. VTK's triangle filter refuses such rings,
 * and VTK's contour triangulator and Delaunay filter lose parts of outlines with many
 * holes.
 * \return counter-clockwise triangles; not all of them if the ring runs out of ears */
std::vector<Triangle>
clipEars (CornerIndices ring, const PlanarPoints& corners)
{
  constexpr std::size_t corners_of_triangle = 3;
  std::vector<Triangle> triangles;
  std::size_t position = 0;
  while (ring.size() >= corners_of_triangle) {
    const std::optional<std::size_t> ear =
        nextPosition (ring, position, [&] (const Triangle& triangle) {
          return isEar (triangle, ring, corners);
        });
    // A corner in line with its neighbors covers no area, but may block ears.
    const std::optional<std::size_t> clipped =
        ear ? ear : nextPosition (ring, position, [&] (const Triangle& triangle) {
          const auto& [a, b, c] = triangle;
          return twiceTheArea (corners[a], corners[b], corners[c]) == 0.0;
        });
    if (!clipped)
      break;
    if (ear)
      triangles.push_back (triangleAt (ring, *ear));
    ring.erase (ring.begin() + *clipped);
    // Skip a corner: else all triangles would meet in one corner.
    position = *clipped + 1;
  }
  return triangles;
}

} // namespace

std::vector<Triangle>
triangulate (const PlanarRings& rings)
{
  // Largest difference of the areas of triangles and outline, as a share of the latter.
  constexpr double tolerance = 1e-6;
  if (rings.empty() || rings.front().empty())
    return {};
  PlanarRings nonempty;
  PlanarPoints corners;
  double area = 0.0;
  for (const PlanarPoints& ring : rings) {
    if (!ring.empty())
      nonempty.push_back (ring);
    corners.insert (corners.end(), ring.begin(), ring.end());
    area += areaOf (ring);
  }
  const std::vector<Triangle> triangles =
      clipEars (joinByBridges (nonempty, corners), corners);
  double covered = 0.0;
  for (const auto& [a, b, c] : triangles)
    covered += 0.5 * twiceTheArea (corners[a], corners[b], corners[c]);
  return std::abs (covered - area) < tolerance * area ? triangles
                                                      : std::vector<Triangle>();
}

} // namespace pcl_ops

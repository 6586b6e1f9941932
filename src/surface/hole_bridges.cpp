// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "hole_bridges.h"

#include "geometry/planar_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl_ops {

namespace {

using namespace internal;

using Numbers = std::vector<std::size_t>;

/** \brief Where a ray to the right first meets a ring: the place of that side, and how
 * far to the right. */
struct Landing {
  std::size_t side = 0;
  double x = std::numeric_limits<double>::infinity();
};

Landing
landingOf (const Eigen::Vector2d& from,
           const Numbers& ring,
           const PlanarPoints& corners)
{
  Landing landing;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    // On the right the ring around runs upwards.
    const Eigen::Vector2d& low = corners[ring[i]];
    const Eigen::Vector2d& high = corners[ring[(i + 1) % ring.size()]];
    if (!(low.y() <= from.y() && high.y() > from.y()))
      continue;
    const double share = (from.y() - low.y()) / (high.y() - low.y());
    const double x = low.x() + share * (high.x() - low.x());
    if (x >= from.x() && x < landing.x)
      landing = {i, x};
  }
  return landing;
}

/** \brief Whether the straight way from a ring's corner to a point begins within. */
bool
leadsInside (const Numbers& ring,
             std::size_t place,
             const Eigen::Vector2d& to,
             const PlanarPoints& corners)
{
  const Eigen::Vector2d& at = corners[ring[place]];
  const Eigen::Vector2d& next = corners[ring[(place + 1) % ring.size()]];
  const Eigen::Vector2d& last = corners[ring[(place + ring.size() - 1) % ring.size()]];
  const bool is_left_of_next = twiceTheArea (at, next, to) >= 0.0;
  const bool is_right_of_last = twiceTheArea (at, last, to) <= 0.0;
  const bool is_convex = twiceTheArea (last, at, next) >= 0.0;
  return is_convex ? is_left_of_next && is_right_of_last
                   : is_left_of_next || is_right_of_last;
}

/** \brief The corner of the ring that is seen from a point inside: the farther end of
 * the side to its right, or the corner before it that is next to the ray. */
std::size_t
visibleFrom (const Eigen::Vector2d& from,
             const Numbers& ring,
             const PlanarPoints& corners)
{
  const Landing landing = landingOf (from, ring, corners);
  const Eigen::Vector2d on_side (landing.x, from.y());
  const std::size_t next = (landing.side + 1) % ring.size();
  std::size_t visible =
      corners[ring[landing.side]].x() > corners[ring[next]].x() ? landing.side : next;
  const Eigen::Vector2d& end = corners[ring[visible]];
  double steepest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& corner = corners[ring[i]];
    const Eigen::Vector2d way = corner - from;
    const double slope = std::abs (way.y()) / way.x();
    const bool is_candidate = corner == end || isWithin (corner, from, on_side, end);
    if (!is_candidate || !(way.x() > 0.0) || !leadsInside (ring, i, from, corners))
      continue;
    const bool is_nearer =
        slope == steepest && way.x() < (corners[ring[visible]] - from).x();
    if (slope < steepest || is_nearer) {
      steepest = slope;
      visible = i;
    }
  }
  return visible;
}

} // namespace

std::vector<std::size_t>
joinByBridges (const PlanarRings& rings, const PlanarPoints& corners)
{
  Numbers ring (rings.front().size());
  std::iota (ring.begin(), ring.end(), 0);
  std::vector<Numbers> holes;
  std::size_t first = ring.size();
  const auto is_left = [&] (std::size_t a, std::size_t b) {
    return corners[a].x() < corners[b].x();
  };
  for (std::size_t r = 1; r < rings.size(); first += rings[r++].size()) {
    Numbers hole (rings[r].size());
    std::iota (hole.begin(), hole.end(), first);
    // Its rightmost corner first: the bridge begins there.
    std::rotate (
        hole.begin(), std::max_element (hole.begin(), hole.end(), is_left), hole.end());
    holes.push_back (hole);
  }
  // From the right, so that a bridge meets no hole that is not yet part of the ring.
  std::stable_sort (holes.begin(), holes.end(), [&] (const auto& a, const auto& b) {
    return is_left (b.front(), a.front());
  });
  for (Numbers& hole : holes) {
    const std::size_t visible = visibleFrom (corners[hole.front()], ring, corners);
    hole.push_back (hole.front());
    hole.push_back (ring[visible]);
    ring.insert (ring.begin() + static_cast<std::ptrdiff_t> (visible) + 1,
                 hole.begin(),
                 hole.end());
  }
  return ring;
}

} // namespace pcl_ops

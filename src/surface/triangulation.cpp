// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/planar_area.h"
#include "hole_bridges.h"
#include <pcl_ops/surface/triangulation.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace pcl_ops {

namespace {

using namespace internal;

using Numbers = std::vector<std::size_t>;

Triangle
triangleAt (const Numbers& ring, std::size_t place)
{
  const std::size_t size = ring.size();
  return {ring[(place + size - 1) % size], ring[place], ring[(place + 1) % size]};
}

bool
isEar (const Triangle& triangle, const Numbers& ring, const PlanarPoints& corners)
{
  const Eigen::Vector2d& a = corners[triangle[0]];
  const Eigen::Vector2d& b = corners[triangle[1]];
  const Eigen::Vector2d& c = corners[triangle[2]];
  if (!(twiceTheArea (a, b, c) > 0.0))
    return false;
  return std::none_of (ring.begin(), ring.end(), [&] (std::size_t other) {
    const Eigen::Vector2d& corner = corners[other];
    // The other end of a bridge is at the same place.
    return corner != a && corner != b && corner != c && isWithin (corner, a, b, c);
  });
}

/** \brief The next place, from one on, that a test holds for. */
template <typename Test>
std::optional<std::size_t>
nextPlace (const Numbers& ring, std::size_t from, Test&& holds)
{
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t place = (from + i) % ring.size();
    if (holds (triangleAt (ring, place)))
      return place;
  }
  return {};
}

/** \brief Cuts a ring that may touch itself, as one with bridges does, into
 * triangles: takes ears off, corners whose triangle has no other corner in it
 * (Meisters, Polygons have ears, 1975). VTK's triangle filter refuses such rings, its
 * contour triangulator and Delaunay filter lose parts of outlines with many holes.
 * \return counter-clockwise; those up to where there was no ear */
std::vector<Triangle>
clipEars (Numbers ring, const PlanarPoints& corners)
{
  constexpr std::size_t corners_of_triangle = 3;
  std::vector<Triangle> triangles;
  std::size_t place = 0;
  while (ring.size() >= corners_of_triangle) {
    const auto ear = nextPlace (ring, place, [&] (const Triangle& triangle) {
      return isEar (triangle, ring, corners);
    });
    // What is on one line covers nothing, but may be in the way of ears.
    const auto clipped =
        ear ? ear : nextPlace (ring, place, [&] (const Triangle& triangle) {
          const auto& [a, b, c] = triangle;
          return twiceTheArea (corners[a], corners[b], corners[c]) == 0.0;
        });
    if (!clipped)
      break;
    if (ear)
      triangles.push_back (triangleAt (ring, *ear));
    ring.erase (ring.begin() + static_cast<std::ptrdiff_t> (*clipped));
    place = *clipped + 1; // every other ear: no fans of slivers
  }
  return triangles;
}

} // namespace

std::vector<Triangle>
triangulate (const PlanarRings& rings)
{
  constexpr double tolerance = 1e-6;
  if (rings.empty() || rings.front().empty())
    return {};
  PlanarRings filled;
  std::copy_if (rings.begin(),
                rings.end(),
                std::back_inserter (filled),
                [] (const PlanarPoints& ring) { return !ring.empty(); });
  PlanarPoints corners;
  double area = 0.0;
  for (const PlanarPoints& ring : filled) {
    corners.insert (corners.end(), ring.begin(), ring.end());
    area += areaOf (ring);
  }
  const std::vector<Triangle> triangles =
      clipEars (joinByBridges (filled, corners), corners);
  double covered = 0.0;
  for (const auto& [a, b, c] : triangles)
    covered += 0.5 * twiceTheArea (corners[a], corners[b], corners[c]);
  return std::abs (covered - area) < tolerance * area ? triangles
                                                      : std::vector<Triangle>();
}

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Boost 1.74 prints a deprecation note on one of its own headers in every build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#undef BOOST_ALLOW_DEPRECATED_HEADERS

#include "overlap.h"
#include <numbers/angles.h>
#include <pcl_ops/plane_extent.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::apps {

namespace {

using Polygon =
    boost::geometry::model::polygon<boost::geometry::model::d2::point_xy<double>,
                                    false>;

Polygon
onto (const PlaneFrame& frame, const PlaneExtent& extent)
{
  Polygon polygon;
  for (const Eigen::Vector3d& corner : extent.hull) {
    const Eigen::Vector2d place = frame.toPlane (corner);
    boost::geometry::append (
        polygon.outer(),
        boost::geometry::model::d2::point_xy<double> (place.x(), place.y()));
  }
  boost::geometry::correct (polygon);
  return polygon;
}

/** \brief Returns the distance of two planes [m] if they pass the tests on angle,
 * distance and size; else nothing. Outlines are not tested here. */
std::optional<double>
distanceOfParallel (const PlaneSegment& larger, const PlaneSegment& smaller)
{
  const double max_angle = toRadians (7.0);
  // In units of the rms distance. Planes farther apart are two: a board before a wall.
  constexpr double max_distance_in_noise = 3.0;
  constexpr double min_share = 0.02;
  const auto size = static_cast<double> (smaller.inliers.size());
  if (size < min_share * static_cast<double> (larger.inliers.size()) ||
      angleBetween (larger, smaller) > max_angle)
    return std::nullopt;
  const Eigen::Vector3d between = larger.centroid - smaller.centroid;
  const double distance = std::max (std::abs (smaller.normal.dot (between)),
                                    std::abs (larger.normal.dot (between)));
  if (distance > max_distance_in_noise * std::max (larger.rms(), smaller.rms()))
    return std::nullopt;
  return distance;
}

/** \brief Computes the extent of each plane at most once, as a plane may be in many
 * pairs. */
class Extents {
public:
  Extents (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes)
  : cloud_ (cloud), planes_ (planes), known_ (planes.size())
  {}

  const PlaneExtent&
  operator[] (std::size_t plane)
  {
    if (!known_[plane])
      known_[plane] = planeExtent (cloud_, planes_[plane]);
    return *known_[plane];
  }

private:
  const XyzCloud& cloud_;
  const std::vector<PlaneSegment>& planes_;
  std::vector<std::optional<PlaneExtent>> known_;
};

/** \brief Whether outlines overlap or nearly touch.
 * \param[in] points number of inliers of the smaller plane */
bool
areBesideEachOther (const PlaneExtent& larger,
                    const PlaneExtent& smaller,
                    const Eigen::Vector3d& normal,
                    std::size_t points)
{
  constexpr double max_gap_in_spacings = 4.0;
  const PlaneFrame frame (larger.center, normal);
  const Polygon first = onto (frame, larger);
  const Polygon second = onto (frame, smaller);
  if (first.outer().empty() || second.outer().empty())
    return false;
  const double spacing = std::sqrt (smaller.area / static_cast<double> (points));
  return boost::geometry::distance (first, second) <= max_gap_in_spacings * spacing;
}

} // namespace

std::optional<OverlappingPlanes>
findOverlapping (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes)
{
  Extents extents (cloud, planes);
  for (std::size_t smaller = 1; smaller < planes.size(); ++smaller)
    for (std::size_t larger = 0; larger < smaller; ++larger) {
      const auto distance = distanceOfParallel (planes[larger], planes[smaller]);
      if (distance && areBesideEachOther (extents[larger],
                                          extents[smaller],
                                          planes[larger].normal,
                                          planes[smaller].inliers.size()))
        return OverlappingPlanes{larger, smaller, *distance};
    }
  return std::nullopt;
}

} // namespace pcl_ops::apps

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

using PlanarPoint = boost::geometry::model::d2::point_xy<double>;
constexpr bool is_clockwise = false;
using Polygon = boost::geometry::model::polygon<PlanarPoint, is_clockwise>;

/** \brief Returns the hull of an extent, projected onto the plane of a frame. */
Polygon
projectedHull (const PlaneExtent& extent, const PlaneFrame& frame)
{
  Polygon polygon;
  for (const Eigen::Vector3d& corner : extent.hull) {
    const Eigen::Vector2d projected = frame.toPlane (corner);
    boost::geometry::append (polygon.outer(),
                             PlanarPoint (projected.x(), projected.y()));
  }
  boost::geometry::correct (polygon);
  return polygon;
}

/** \brief Returns OverlappingPlanes::distance if two planes pass the tests of \ref
 * findOverlapping on angle, distance and size; else nothing. Outlines are not tested.
 */
std::optional<double>
distanceIfParallel (const PlaneSegment& larger, const PlaneSegment& smaller)
{
  // The limits are chosen by hand. Whether the pair merges is checked later, by a
  // detection (addHintOnOverlap in methods.cpp).
  const double max_angle = toRadians (7.0);
  // Planes farther apart are two surfaces, as a board in front of a wall.
  constexpr double max_distance_by_rms = 3.0;
  constexpr double min_size_ratio = 0.02;
  const auto size = static_cast<double> (smaller.inliers.size());
  const bool is_too_small =
      size < min_size_ratio * static_cast<double> (larger.inliers.size());
  if (is_too_small || angleBetween (larger, smaller) > max_angle)
    return std::nullopt;
  const Eigen::Vector3d between = larger.centroid - smaller.centroid;
  const double distance = std::max (std::abs (smaller.normal.dot (between)),
                                    std::abs (larger.normal.dot (between)));
  if (distance > max_distance_by_rms * std::max (larger.rms(), smaller.rms()))
    return std::nullopt;
  return distance;
}

/** \brief Computes the extent of a plane when it is first asked for, and keeps it, as a
 * plane may be in many pairs. */
class Extents {
public:
  Extents (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes)
  : cloud_ (cloud), planes_ (planes), known_ (planes.size())
  {}

  /** \param[in] plane its index in the list of planes */
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

/** \brief Whether the outlines of two planes pass the test of \ref findOverlapping.
 * \param[in] normal of the larger plane
 * \param[in] inliers_of_smaller number of inliers of the smaller plane */
bool
doOutlinesOverlap (const PlaneExtent& larger,
                   const PlaneExtent& smaller,
                   const Eigen::Vector3d& normal,
                   std::size_t inliers_of_smaller)
{
  constexpr double max_gap_in_spacings = 4.0; // chosen by hand
  const PlaneFrame frame (larger.center, normal);
  const Polygon larger_hull = projectedHull (larger, frame);
  const Polygon smaller_hull = projectedHull (smaller, frame);
  if (larger_hull.outer().empty() || smaller_hull.outer().empty())
    return false;
  const double spacing =
      std::sqrt (smaller.area / static_cast<double> (inliers_of_smaller));
  const double gap = boost::geometry::distance (larger_hull, smaller_hull);
  return gap <= max_gap_in_spacings * spacing;
}

} // namespace

std::optional<OverlappingPlanes>
findOverlapping (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes)
{
  Extents extents (cloud, planes);
  for (std::size_t smaller = 1; smaller < planes.size(); ++smaller)
    for (std::size_t larger = 0; larger < smaller; ++larger) {
      const std::optional<double> distance =
          distanceIfParallel (planes[larger], planes[smaller]);
      if (distance && doOutlinesOverlap (extents[larger],
                                         extents[smaller],
                                         planes[larger].normal,
                                         planes[smaller].inliers.size()))
        return OverlappingPlanes{larger, smaller, *distance};
    }
  return std::nullopt;
}

} // namespace pcl_ops::apps

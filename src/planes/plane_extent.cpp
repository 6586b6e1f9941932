// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "base/random.h"
#include "geometry/inliers.h"
#include "geometry/planar_area.h"
#include "planes/planar_ring.h"
#include <pcl_ops/plane_extent.h>

#include <algorithm>
#include <limits>

namespace pcl_ops {
using namespace internal;
namespace {

constexpr std::size_t corners_of_an_area = 3;

/** \brief Depth of each point inside a convex hull [m]; negative outside. */
std::vector<double>
depthsWithin (const PlanarPoints& hull, const PlanarPoints& points)
{
  std::vector<double> depths (points.size(), std::numeric_limits<double>::infinity());
  for (std::size_t e = 0; e < hull.size(); ++e) {
    const Eigen::Vector2d edge = (hull[(e + 1) % hull.size()] - hull[e]).normalized();
    const Eigen::Vector2d inwards (-edge.y(), edge.x());
    const double offset = inwards.dot (hull[e]);
    for (std::size_t i = 0; i < points.size(); ++i)
      depths[i] = std::min (depths[i], inwards.dot (points[i]) - offset);
  }
  return depths;
}

/** \brief Removes the points whose depth is at most \p depth, and returns them.
 * \param[in] depths of the points, by \ref depthsWithin */
PlanarPoints
splitOff (PlanarPoints& points, const std::vector<double>& depths, double depth)
{
  PlanarPoints removed;
  PlanarPoints kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (depths[i] <= depth)
      removed.push_back (points[i]);
    else
      kept.push_back (points[i]);
  points.swap (kept);
  return removed;
}

/** \brief Largest depth that rounding gives corners, whose depth is 0 [m]. */
double
depthOfCorners (const PlanarPoints& hull)
{
  constexpr double rounding = 1e-12; // several thousand times that of a double
  double largest = 0.0;
  for (const Eigen::Vector2d& corner : hull)
    largest = std::max (largest, corner.lpNorm<Eigen::Infinity>());
  return rounding * largest;
}

/** \brief The convex hull of finite points: counter-clockwise, the first corner not
 * repeated; empty where the points span no area. */
PlanarPoints
hullOfAll (const PlanarPoints& points)
{
  if (points.size() < corners_of_an_area)
    return {};
  const double scale = unitScale (points);
  boost::geometry::model::multi_point<Eigen::Vector2d> cloud;
  cloud.reserve (points.size());
  for (const Eigen::Vector2d& point : points)
    cloud.push_back (scale * point);
  Ring ring;
  boost::geometry::convex_hull (cloud, ring);
  PlanarPoints hull;
  double longest = 0.0;
  for (const Eigen::Vector2d& corner : ring) {
    hull.push_back (corner / scale);
    longest = std::max (longest, (hull.back() - hull.front()).norm());
  }
  // Rounding of the inputs (single precision) alone can give a line this much width.
  constexpr double smallest_width = 1e-5;
  if (hull.size() < corners_of_an_area ||
      !(areaOf (hull) > smallest_width * longest * longest))
    return {};
  return hull;
}

/** \brief A convex hull around all but a few per cent of the points, from a random
 * sample; empty for up to 2048 points, which are too few for a sample. */
PlanarPoints
innerHull (const PlanarPoints& points)
{
  constexpr std::size_t sample_size = 2048;
  constexpr std::size_t one_outside_in = 32; // one of 32 points of the sample
  if (points.size() <= sample_size)
    return {};
  RandomGenerator generator; // default seed: users give none
  PlanarPoints sample;
  for (std::size_t i = 0; i < sample_size; ++i)
    sample.push_back (
        points[drawBelow (generator, static_cast<std::uint32_t> (points.size()))]);
  PlanarPoints hull = hullOfAll (sample);
  // Removes corners of the hull until enough of the sample lies outside it.
  while (!hull.empty() && sample.size() > sample_size - sample_size / one_outside_in) {
    splitOff (sample, depthsWithin (hull, sample), depthOfCorners (hull));
    hull = hullOfAll (sample);
  }
  return hull;
}

/** \brief Removes the outermost points: the corners of the hull around all, and the
 * points nearest to its border.
 * \param[in] min_removed how many points to remove at least, if there are as many; 1 or
 * more
 * \return how many points were removed */
std::size_t
takeOffLayer (PlanarPoints& points, const PlanarPoints& hull, std::size_t min_removed)
{
  if (points.empty())
    return 0;
  const std::vector<double> depths = depthsWithin (hull, points);
  std::vector<double> ordered = depths;
  const auto last = ordered.begin() + std::min (min_removed, ordered.size()) - 1;
  std::nth_element (ordered.begin(), last, ordered.end());
  return splitOff (points, depths, std::max (*last, depthOfCorners (hull))).size();
}

/** \brief A rectangle: a box in the frame of the unit vector u and the axis to its
 * left. */
struct Rectangle {
  Eigen::Vector2d u = Eigen::Vector2d::UnitX();
  Eigen::AlignedBox2d box{Eigen::Vector2d::Zero()};

  Eigen::Vector2d
  left () const
  {
    return {-u.y(), u.x()};
  }
  Eigen::Vector2d
  center () const
  {
    return box.center().x() * u + box.center().y() * left();
  }
};

/** \brief The bounding rectangle of points that has a side along the unit vector u. */
Rectangle
rectangleAlong (const Eigen::Vector2d& u, const PlanarPoints& points)
{
  Rectangle rectangle{u, Eigen::AlignedBox2d()};
  for (const Eigen::Vector2d& point : points)
    rectangle.box.extend (
        Eigen::Vector2d (u.dot (point), rectangle.left().dot (point)));
  return rectangle;
}

/** \brief The minimum-area bounding rectangle of a convex hull. */
Rectangle
smallestRectangle (const PlanarPoints& hull)
{
  // A side of this rectangle lies along an edge of the hull.
  Rectangle smallest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
    const Rectangle rectangle = rectangleAlong (edge.normalized(), hull);
    const double area = rectangle.box.volume();
    if (area < least) {
      least = area;
      smallest = rectangle;
    }
  }
  return smallest;
}

/** \brief The bounding rectangle of points on one line, with width 0. */
Rectangle
rectangleAlongLine (const PlanarPoints& points)
{
  if (points.empty())
    return {};
  // Direction of the line, from two points that are far apart.
  const auto farthestFrom = [&] (const Eigen::Vector2d& from) {
    return *std::max_element (
        points.begin(), points.end(), [&] (const auto& first, const auto& second) {
          return (first - from).squaredNorm() < (second - from).squaredNorm();
        });
  };
  const Eigen::Vector2d end = farthestFrom (points.front());
  const Eigen::Vector2d along = farthestFrom (end) - end;
  Rectangle rectangle = rectangleAlong (
      along.isZero (0.0) ? Eigen::Vector2d::UnitX() : along.normalized(), points);
  const double middle = rectangle.center().dot (rectangle.left());
  rectangle.box.min().y() = rectangle.box.max().y() = middle;
  return rectangle;
}

} // namespace

PlaneFrame::PlaneFrame (const Eigen::Vector3d& origin, const Eigen::Vector3d& normal)
: origin_ (origin), axes_ (planeAxes (normal))
{}

PlanarPoints
convexHull (const PlanarPoints& points, double max_outside)
{
  // Noise blurs the edge of a surface: there the density is half of that inside.
  constexpr double edge_density = 0.5;
  // Number of layers that use up the points allowed outside: each layer has enough
  // points to measure a density.
  constexpr std::size_t layers = 16;
  PlanarPoints rim = finiteOf (points); // the points that may still be corners
  const auto all = static_cast<double> (rim.size());
  const auto max_points_outside = static_cast<std::size_t> (max_outside * all);
  // Points inside the inner hull stay, and are not looked at again.
  const PlanarPoints inner_hull = innerHull (rim);
  if (!inner_hull.empty())
    rim = splitOff (rim, depthsWithin (inner_hull, rim), 0.0);
  const auto hull_of_rest = [&] {
    PlanarPoints rest = rim;
    rest.insert (rest.end(), inner_hull.begin(), inner_hull.end());
    return hullOfAll (rest);
  };
  PlanarPoints hull = hull_of_rest();
  for (std::size_t outside = 0; !hull.empty();) {
    const std::size_t layer_points =
        takeOffLayer (rim, hull, max_points_outside / layers + 1);
    outside += layer_points;
    if (outside > max_points_outside)
      break;
    const PlanarPoints next_hull = hull_of_rest();
    const double area = areaOf (next_hull);
    const double layer_area = areaOf (hull) - area;
    // The density of the layer is layer_points / layer_area, that of all points
    // all / area.
    const bool is_sparse =
        static_cast<double> (layer_points) * area < edge_density * all * layer_area;
    if (next_hull.empty() || !is_sparse)
      break;
    hull = next_hull;
  }
  return hull;
}

PlaneExtent
extentOf (const PlanarRings& rings, const PlanarPoints& points, const PlaneFrame& frame)
{
  const PlanarPoints outline = rings.empty() ? PlanarPoints() : rings.front();
  const PlanarPoints hull = hullOfAll (outline);
  const Rectangle rectangle =
      hull.empty() ? rectangleAlongLine (finiteOf (points)) : smallestRectangle (hull);
  const Eigen::Vector2d sides = rectangle.box.sizes();
  const bool is_long = sides.x() >= sides.y();
  PlaneExtent extent;
  for (const Eigen::Vector2d& corner : outline)
    extent.hull.push_back (frame.toSpace (corner));
  extent.area = areaOf (outline);
  extent.center = frame.toSpace (rectangle.center());
  extent.long_axis = frame.directionInSpace (is_long ? rectangle.u : rectangle.left());
  extent.short_axis =
      frame.directionInSpace (is_long ? rectangle.left() : -rectangle.u);
  extent.length = sides.maxCoeff();
  extent.width = sides.minCoeff();
  for (std::size_t hole = 1; hole < rings.size(); ++hole) {
    extent.area += areaOf (rings[hole]); // negative: clockwise
    extent.holes.emplace_back();
    for (const Eigen::Vector2d& corner : rings[hole])
      extent.holes.back().push_back (frame.toSpace (corner));
  }
  return extent;
}

PlanarPoints
pointsOnPlane (const CloudView& cloud,
               const PlaneSegment& plane,
               const PlaneFrame& frame)
{
  checkInliers (cloud, plane);
  PlanarPoints points;
  points.reserve (plane.inliers.size());
  for (const pcl::index_t index : plane.inliers) {
    const float* const point = cloud[index];
    points.push_back (frame.toPlane (Eigen::Vector3d (point[0], point[1], point[2])));
  }
  return points;
}

PlaneExtent
planeExtent (const CloudView& cloud, const PlaneSegment& plane)
{
  const PlaneFrame frame (plane.centroid, plane.normal);
  const PlanarPoints points = pointsOnPlane (cloud, plane, frame);
  return extentOf ({convexHull (points)}, points, frame);
}

} // namespace pcl_ops

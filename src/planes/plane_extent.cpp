// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "cloud/points.h"
#include "geometry/inliers.h"
#include "geometry/planar_area.h"
#include "planes/planar_ring.h"
#include <pcl_ops/plane_extent.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_ops {
using namespace internal;
namespace {

constexpr std::size_t min_corners_of_area = 3;

/** \brief Returns for each point how deep it lies in a convex hull: its distance to the
 * nearest edge line [m], negative outside. */
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

/** \brief Removes the points whose depth is at most \p max_depth [m], and returns them.
 * \param[in] depths of the points, by \ref depthsWithin */
PlanarPoints
splitOff (PlanarPoints& points, const std::vector<double>& depths, double max_depth)
{
  PlanarPoints removed;
  PlanarPoints kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (depths[i] <= max_depth)
      removed.push_back (points[i]);
    else
      kept.push_back (points[i]);
  points.swap (kept);
  return removed;
}

/** \brief Largest depth that \ref depthsWithin finds for the corners of a hull [m]:
 * their depth is 0, but for rounding. */
double
depthOfCorners (const PlanarPoints& hull)
{
  constexpr double rounding = 1e-12; // several thousand times the precision of a double
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
  if (points.size() < min_corners_of_area)
    return {};
  const double scale = unitScale (points);
  boost::geometry::model::multi_point<Eigen::Vector2d> cloud;
  cloud.reserve (points.size());
  for (const Eigen::Vector2d& point : points)
    cloud.push_back (scale * point);
  Ring ring;
  boost::geometry::convex_hull (cloud, ring);
  PlanarPoints hull;
  double longest = 0.0; // from the first corner to another one
  for (const Eigen::Vector2d& corner : ring) {
    hull.push_back (corner / scale);
    longest = std::max (longest, (hull.back() - hull.front()).norm());
  }
  // Width over length: rounding of coordinates to single precision can give a line this
  // much width.
  constexpr double min_width_over_length = 1e-5;
  if (hull.size() < min_corners_of_area ||
      !(areaOf (hull) > min_width_over_length * longest * longest))
    return {};
  return hull;
}

/** \brief Returns a sample of about \p wanted points, the same for any order of the
 * points. Their coordinates are rounded to a millionth of the largest one for it: they
 * differ in their last digits if the cloud has another order. */
PlanarPoints
sampleOf (const PlanarPoints& points, std::size_t wanted)
{
  constexpr int bits = 20;
  double largest = 0.0;
  for (const Eigen::Vector2d& point : points)
    largest = std::max (largest, point.lpNorm<Eigen::Infinity>());
  const double scale =
      largest > 0.0 ? std::ldexp (1.0, bits - std::ilogb (largest)) : 1.0;
  const auto rounded = [scale] (double coordinate) {
    return static_cast<float> (std::round (coordinate * scale)) + 0.0F; // no minus zero
  };
  Coordinates coordinates;
  for (const Eigen::Vector2d& point : points)
    coordinates.add (rounded (point.x()), rounded (point.y()), 0.0F);
  PlanarPoints sample;
  for (const std::uint32_t i : sampleIndices (coordinates, wanted))
    sample.push_back (points[i]);
  return sample;
}

/** \brief A convex hull around all but a few percent of the points, from a sample;
 * empty for up to 2048 points, which are too few for a sample. */
PlanarPoints
innerHull (const PlanarPoints& points)
{
  constexpr std::size_t sample_size = 2048; // chosen by hand
  if (points.size() <= sample_size)
    return {};
  PlanarPoints sample = sampleOf (points, sample_size);
  // 3 percent of the sample: more than may be outside by default (convexHull).
  const std::size_t max_inside = sample.size() - sample.size() / 32;
  PlanarPoints hull = hullOfAll (sample);
  // Remove corners of the hull until enough of the sample lies outside it.
  while (!hull.empty() && sample.size() > max_inside) {
    splitOff (sample, depthsWithin (hull, sample), depthOfCorners (hull));
    hull = hullOfAll (sample);
  }
  return hull;
}

/** \brief Removes the outermost points: the corners of the hull, and the points nearest
 * to its edges.
 * \param[in] hull the convex hull around all points
 * \param[in] min_removed how many points to remove at least, 1 or more; all points if
 * there are fewer
 * \return how many points were removed */
std::size_t
removeLayer (PlanarPoints& points, const PlanarPoints& hull, std::size_t min_removed)
{
  if (points.empty())
    return 0;
  const std::vector<double> depths = depthsWithin (hull, points);
  std::vector<double> ordered_depths = depths;
  const auto last_removed =
      ordered_depths.begin() + std::min (min_removed, ordered_depths.size()) - 1;
  std::nth_element (ordered_depths.begin(), last_removed, ordered_depths.end());
  const double max_depth = std::max (*last_removed, depthOfCorners (hull));
  return splitOff (points, depths, max_depth).size();
}

/** \brief A rectangle: a box with coordinates along the unit vector u and along \ref
 * left, u turned by 90 degrees counter-clockwise. */
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

/** \brief Of all bounding rectangles of a convex hull, the one with the smallest area.
 */
Rectangle
smallestRectangle (const PlanarPoints& hull)
{
  // A side of the smallest rectangle lies along an edge of the hull.
  Rectangle smallest;
  double least_area = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
    const Rectangle rectangle = rectangleAlong (edge.normalized(), hull);
    const double area = rectangle.box.volume();
    if (area < least_area) {
      least_area = area;
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
  // The line runs along two points that are far apart.
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

/** \brief Whether a layer of the outermost points has stray points: it has less than
 * half as many points per area as the points inside. Noise blurs the edge of a surface:
 * at the edge the points per area are half of those inside.
 * \param[in] layer_points number of points of the layer
 * \param[in] layer_area area between the hulls with and without the layer
 * \param[in] all_points number of all points
 * \param[in] area of the hull without the layer */
bool
isSparse (std::size_t layer_points, double layer_area, double all_points, double area)
{
  constexpr double edge_density = 0.5;
  // layer_points / layer_area < edge_density all_points / area
  return static_cast<double> (layer_points) * area <
         edge_density * all_points * layer_area;
}

} // namespace

PlaneFrame::PlaneFrame (const Eigen::Vector3d& origin, const Eigen::Vector3d& normal)
: origin_ (origin), axes_ (planeAxes (normal))
{}

PlanarPoints
convexHull (const PlanarPoints& points, double max_outside)
{
  // The outermost points are removed layer by layer. The points that may be outside
  // fill this many layers, so that each layer has enough points to measure its density.
  constexpr std::size_t layers = 16;    // chosen by hand
  PlanarPoints rim = finiteOf (points); // the points that may still be corners
  const auto all_points = static_cast<double> (rim.size());
  const double max_share = max_outside > 0.0 ? std::min (max_outside, 1.0) : 0.0;
  const auto max_points_outside = static_cast<std::size_t> (max_share * all_points);
  // Points inside the inner hull stay inside, and are not looked at again.
  const PlanarPoints inner_hull = innerHull (rim);
  if (!inner_hull.empty())
    rim = splitOff (rim, depthsWithin (inner_hull, rim), 0.0);
  const auto hullOfRest = [&] {
    PlanarPoints rest = rim;
    rest.insert (rest.end(), inner_hull.begin(), inner_hull.end());
    return hullOfAll (rest);
  };
  PlanarPoints hull = hullOfRest();
  // A layer has all corners of the hull that are in the rim. If there are more of them
  // than points that may be outside, as for points on a circle, no layer is removed.
  const auto mayRemoveLayer = [&] {
    return !hull.empty() && hull.size() <= max_points_outside + inner_hull.size();
  };
  for (std::size_t outside = 0; mayRemoveLayer();) {
    const std::size_t layer_points =
        removeLayer (rim, hull, max_points_outside / layers + 1);
    outside += layer_points;
    if (outside > max_points_outside)
      break;
    const PlanarPoints next_hull = hullOfRest();
    const double area = areaOf (next_hull);
    const double layer_area = areaOf (hull) - area;
    if (next_hull.empty() || !isSparse (layer_points, layer_area, all_points, area))
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
  const bool is_u_long = sides.x() >= sides.y();
  PlaneExtent extent;
  for (const Eigen::Vector2d& corner : outline)
    extent.hull.push_back (frame.toSpace (corner));
  extent.area = areaOf (outline);
  extent.center = frame.toSpace (rectangle.center());
  extent.long_axis =
      frame.directionInSpace (is_u_long ? rectangle.u : rectangle.left());
  extent.short_axis =
      frame.directionInSpace (is_u_long ? rectangle.left() : -rectangle.u);
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

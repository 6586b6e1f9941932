// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Dense>

#include "geometry/angles.h"
#include "geometry/inliers.h"
#include "geometry/planar_area.h"
#include "planes/intervals.h"
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_extent.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace pcl_ops {
namespace {

using namespace internal;
using Eigen::Vector3d;

/** \brief Returns the intersections of the intervals of two ascending lists that are \p
 * min_length [m] long or longer, and longer than 0. */
Intervals
intersectionsOf (const Intervals& first, const Intervals& second, double min_length)
{
  Intervals common;
  auto a = first.begin();
  auto b = second.begin();
  while (a != first.end() && b != second.end()) {
    const Interval both{std::max (a->from, b->from), std::min (a->to, b->to)};
    if (both.length() >= min_length && both.length() > 0.0)
      common.push_back (both);
    if (a->to < b->to)
      ++a;
    else
      ++b;
  }
  return common;
}

using Line = Eigen::ParametrizedLine<double, 3>;

/** \brief Two planes that meet: points of both lie near their intersection line. */
struct Meeting {
  /** \brief Indices of the planes, the lower one first. */
  std::size_t first, second;
  /** \brief The intersection line, with a unit direction. */
  Line line;
  /** \brief Angle between the planes, 0 to pi/2 [rad]. */
  double angle;
  /** \brief Largest gap between points of one interval, and from the end of an interval
   * to a corner that it is extended to [m]. */
  double max_gap;
  /** \brief Where points of both planes are near the line. */
  Intervals intervals;
};

/** \brief A plane with its inliers projected onto it, their noise and their spacing. */
struct ProjectedPlane {
  PlaneFrame frame;
  /** \brief The inliers, with coordinates in the plane [m]. */
  PlanarPoints points;
  /** \brief Bounding box of the finite points. */
  Eigen::AlignedBox2d box;
  /** \brief Rms distance of the points to the plane [m]. */
  double rms;
  /** \brief Mean distance between neighboring points [m]. */
  double spacing;
};

// Returns nothing if the inliers span no plane.
// \param[in] shift origin of the cloud's frame in the frame of the plane [m]
std::optional<ProjectedPlane>
projectedPlaneOf (const CloudView& cloud,
                  const PlaneSegment& plane,
                  const Vector3d& shift)
{
  const std::optional<PlaneFit> fit = fitPlane (plane.moments);
  if (!fit)
    return {};
  const PlaneFrame in_cloud (plane.centroid - shift, plane.normal);
  // Area of a rectangle of evenly spread points with these variances: a side is
  // sqrt (12 variance) long.
  const double area = 12.0 * std::sqrt (fit->variances[1] * fit->variances[2]);
  ProjectedPlane projected{PlaneFrame (plane.centroid, plane.normal),
                           pointsOnPlane (cloud, plane, in_cloud),
                           {},
                           std::sqrt (fit->variances[0]),
                           std::sqrt (area / plane.moments.count)};
  for (const Eigen::Vector2d& point : projected.points)
    if (point.allFinite())
      projected.box.extend (point);
  return projected;
}

/** \brief How near to their intersection line two planes must have points [m]. A point
 * within three standard deviations of both planes may be an inlier of either plane, so
 * that one of the planes may have no points nearer to the line.
 * \param[in] sine of the angle between the planes */
double
reachOf (const ProjectedPlane& first, const ProjectedPlane& second, double sine)
{
  constexpr double deviations = 3.0; // standard deviations of the points of both planes
  constexpr double spacings = 4.0;   // of the plane with the larger one; chosen by hand
  return deviations * std::hypot (first.rms, second.rms) / sine +
         spacings * std::max (first.spacing, second.spacing);
}

/** \brief Whether the bounding spheres of the points of two planes are at most 2 \p
 * reach apart [m]. */
bool
areNear (const ProjectedPlane& first, const ProjectedPlane& second, double reach)
{
  const double center_distance = (first.frame.toSpace (first.box.center()) -
                                  second.frame.toSpace (second.box.center()))
                                     .norm();
  const double diameters = first.box.diagonal().norm() + second.box.diagonal().norm();
  return center_distance <= 0.5 * diameters + 2.0 * reach;
}

/** \brief Signed distance of a point to a plane [m]. It is exact for planes far from
 * zero, too: it does not use the offset of the plane, which is not exact there. */
double
signedDistance (const Vector3d& point, const PlaneSegment& plane)
{
  return plane.normal.dot (point - plane.centroid);
}

/** \brief The intersection line of two planes. Its origin is its point nearest to the
 * middle of their centroids.
 * \return nothing if the angle between the planes has a sine below \p min_sine */
std::optional<Line>
meetingLine (const PlaneSegment& first, const PlaneSegment& second, double min_sine)
{
  const Vector3d along = first.normal.cross (second.normal);
  const double sine = along.norm();
  const Vector3d middle = 0.5 * (first.centroid + second.centroid);
  if (!(sine >= min_sine && sine > 0.0) || !middle.allFinite())
    return {};
  // middle + a n1 + b n2 lies on both planes: with their normals n1 and n2, c = n1 . n2
  // and the distances d1 and d2 of the middle, a + c b = -d1 and c a + b = -d2.
  const double c = first.normal.dot (second.normal);
  const double d1 = signedDistance (middle, first);
  const double d2 = signedDistance (middle, second);
  const double a = (c * d2 - d1) / (sine * sine);
  const double b = (c * d1 - d2) / (sine * sine);
  return Line{middle + a * first.normal + b * second.normal, along / sine};
}

/** \brief Coordinates along a line of those points of a plane that are within \p reach
 * of the line [m].
 * \param[in] line in the plane, with a unit direction */
std::vector<double>
coordinatesBeside (const ProjectedPlane& plane, const Line& line, double reach)
{
  const Eigen::Vector2d origin = plane.frame.toPlane (line.origin());
  const Eigen::Vector2d along = plane.frame.toPlane (line.pointAt (1.0)) - origin;
  const double radius = 0.5 * plane.box.diagonal().norm();
  if (std::abs (cross (along, plane.box.center() - origin)) > radius + reach)
    return {};
  std::vector<double> coordinates;
  for (const Eigen::Vector2d& point : plane.points)
    if (std::abs (cross (along, point - origin)) <= reach)
      coordinates.push_back (along.dot (point - origin));
  return coordinates;
}

/** \brief Returns how two planes meet; nothing if they do not.
 * \param[in] first,second indices of the planes, first < second */
std::optional<Meeting>
meetingOf (const std::vector<PlaneSegment>& planes,
           const std::vector<std::optional<ProjectedPlane>>& projected_planes,
           std::size_t first,
           std::size_t second,
           const PlaneEdgeParameters& parameters)
{
  // Defaults of the largest gap and of the smallest length, in units of the reach;
  // chosen by hand.
  constexpr double reaches_of_gap = 2.0;
  constexpr double reaches_of_length = 3.0;
  if (!projected_planes[first] || !projected_planes[second])
    return {};
  const ProjectedPlane& one = *projected_planes[first];
  const ProjectedPlane& other = *projected_planes[second];
  const double angle = angleBetween (planes[first], planes[second]);
  const double reach =
      parameters.reach.value_or (reachOf (one, other, std::sin (angle)));
  if (!areNear (one, other, reach))
    return {};
  const std::optional<Line> line =
      meetingLine (planes[first], planes[second], std::sin (parameters.min_angle));
  if (!line)
    return {};
  const double max_gap = parameters.max_gap.value_or (reaches_of_gap * reach);
  const double min_length = parameters.min_length.value_or (reaches_of_length * reach);
  // Begin with the smaller plane: if it has no points near the line, the larger one
  // need not be searched.
  const bool is_first_smaller = one.points.size() < other.points.size();
  const ProjectedPlane& smaller = is_first_smaller ? one : other;
  const ProjectedPlane& larger = is_first_smaller ? other : one;
  Intervals common = intervalsOf (coordinatesBeside (smaller, *line, reach), max_gap);
  if (!common.empty())
    common = intersectionsOf (
        common,
        intervalsOf (coordinatesBeside (larger, *line, reach), max_gap),
        min_length);
  if (common.empty())
    return {};
  return Meeting{first, second, *line, angle, max_gap, std::move (common)};
}

/** \brief The intersection point of three planes, any two of which meet.
 * \return nothing if a plane and the line of the others are at an angle whose sine is
 * below \p min_sine */
std::optional<Vector3d>
meetingPoint (const PlaneSegment& first,
              const PlaneSegment& second,
              const PlaneSegment& third,
              double min_sine)
{
  Eigen::Matrix3d normals;
  normals << first.normal.transpose(), second.normal.transpose(),
      third.normal.transpose();
  const double volume =
      std::abs (normals.determinant()); // of the normals' parallelepiped
  for (const int i : {0, 1, 2}) {
    const Vector3d along = normals.row (i).cross (normals.row ((i + 1) % 3));
    if (!(volume >= min_sine * along.norm()))
      return {};
  }
  const Vector3d middle = (first.centroid + second.centroid + third.centroid) / 3.0;
  const Vector3d distances (signedDistance (middle, first),
                            signedDistance (middle, second),
                            signedDistance (middle, third));
  return middle - normals.inverse() * distances;
}

/** \brief Whether an interval of a meeting holds a point of its line, or ends within
 * Meeting::max_gap of the point. */
bool
comesTo (const Meeting& meeting, const Vector3d& point)
{
  const double coordinate =
      meeting.line.direction().dot (point - meeting.line.origin());
  for (const Interval& interval : meeting.intervals)
    if (coordinate >= interval.from - meeting.max_gap &&
        coordinate <= interval.to + meeting.max_gap)
      return true;
  return false;
}

/** \brief The corners: the intersection points of three planes, if all three meetings
 * of two of them come to the point (\ref comesTo). They are in ascending order of the
 * planes.
 * \param[in] meetings sorted by their first plane, then by their second */
std::vector<PlaneCorner>
cornersOf (const std::vector<Meeting>& meetings,
           const std::vector<PlaneSegment>& planes,
           double min_sine)
{
  std::vector<PlaneCorner> corners;
  for (auto first = meetings.begin(); first != meetings.end(); ++first)
    for (auto next = first + 1; next != meetings.end() && next->first == first->first;
         ++next) {
      // Three planes: two meetings of i, with j and with k, and perhaps one of j and k.
      const std::size_t i = first->first;
      const std::size_t j = first->second;
      const std::size_t k = next->second;
      const auto last =
          std::find_if (next, meetings.end(), [j, k] (const Meeting& meeting) {
            return meeting.first == j && meeting.second == k;
          });
      if (last == meetings.end())
        continue;
      const std::optional<Vector3d> point =
          meetingPoint (planes[i], planes[j], planes[k], min_sine);
      if (point && comesTo (*first, *point) && comesTo (*next, *point) &&
          comesTo (*last, *point))
        corners.push_back ({{i, j, k}, *point});
    }
  return corners;
}

/** \brief Of the corners that lie on both planes of a meeting, the one nearest to the
 * end of an interval, if it is no farther from the end than Meeting::max_gap; else the
 * end. */
Vector3d
movedToCorner (const Vector3d& end,
               const Meeting& meeting,
               const std::vector<PlaneCorner>& corners)
{
  Vector3d nearest = end;
  double least_distance = meeting.max_gap;
  for (const PlaneCorner& corner : corners) {
    const auto liesOn = [&] (std::size_t plane) {
      return std::count (corner.planes.begin(), corner.planes.end(), plane) > 0;
    };
    const double distance = (corner.position - end).norm();
    if (distance <= least_distance && liesOn (meeting.first) &&
        liesOn (meeting.second)) {
      least_distance = distance;
      nearest = corner.position;
    }
  }
  return nearest;
}

/** \brief Makes an edge of an interval. Both ends move to the corners near them, if the
 * edge then has a length above 0 in the direction of the line. Else only the end that
 * is nearer to its corner moves, if the edge has such a length then. */
PlaneEdge
edgeOf (const Interval& interval,
        const Meeting& meeting,
        const std::vector<PlaneCorner>& corners)
{
  PlaneEdge edge{{meeting.first, meeting.second},
                 meeting.line.pointAt (interval.from),
                 meeting.line.pointAt (interval.to),
                 meeting.angle};
  const Vector3d from = movedToCorner (edge.from, meeting, corners);
  const Vector3d to = movedToCorner (edge.to, meeting, corners);
  const auto hasLength = [&] (const Vector3d& begin, const Vector3d& end) {
    return meeting.line.direction().dot (end - begin) > 0.0;
  };
  const bool is_begin_nearer = (from - edge.from).norm() <= (to - edge.to).norm();
  const bool can_move_both = hasLength (from, to);
  if (can_move_both || (is_begin_nearer && hasLength (from, edge.to)))
    edge.from = from;
  if (can_move_both || (!is_begin_nearer && hasLength (edge.from, to)))
    edge.to = to;
  return edge;
}

bool
isLengthOrNotGiven (const std::optional<double>& length)
{
  return !length || (*length >= 0.0 && std::isfinite (*length));
}

} // namespace

std::string
validate (const PlaneEdgeParameters& parameters)
{
  if (!isLengthOrNotGiven (parameters.reach))
    return "the reach must be a length from 0, or not be given";
  if (!isLengthOrNotGiven (parameters.max_gap))
    return "the bridged gap must be a length from 0, or not be given";
  if (!isLengthOrNotGiven (parameters.min_length))
    return "the smallest length must be a length from 0, or not be given";
  if (!(parameters.min_angle > 0.0 && parameters.min_angle <= max_right_angle))
    return "the smallest angle must be above 0 and at most pi/2 (radians)";
  return {};
}

PlaneEdges
findPlaneEdges (const CloudView& cloud,
                const std::vector<PlaneSegment>& planes,
                const PlaneEdgeParameters& parameters,
                const Eigen::Vector3d& shift)
{
  detail::throwOn (validate (parameters));
  for (const PlaneSegment& plane : planes)
    checkInliers (cloud, plane);
  std::vector<std::optional<ProjectedPlane>> projected_planes;
  for (const PlaneSegment& plane : planes)
    projected_planes.push_back (projectedPlaneOf (cloud, plane, shift));
  // Sorted by their first plane, then by their second.
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j)
      if (std::optional<Meeting> meeting =
              meetingOf (planes, projected_planes, i, j, parameters))
        meetings.push_back (std::move (*meeting));
  PlaneEdges found;
  found.corners = cornersOf (meetings, planes, std::sin (parameters.min_angle));
  for (const Meeting& meeting : meetings)
    for (const Interval& interval : meeting.intervals)
      found.edges.push_back (edgeOf (interval, meeting, found.corners));
  return found;
}

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Dense>

#include "edges/meetings.h"
#include "geometry/angles.h"
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_edges.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_ops {

namespace {

using namespace internal;
using Eigen::Vector3d;

/** \brief The point that three planes have in common, each two of which meet; nothing
 * where one of them is at an angle with a smaller sine to the line of the others. */
std::optional<Vector3d>
meetingPoint (const PlaneSegment& first,
              const PlaneSegment& second,
              const PlaneSegment& third,
              double min_sine)
{
  Eigen::Matrix3d normals;
  normals << first.normal.transpose(), second.normal.transpose(),
      third.normal.transpose();
  const double volume = std::abs (normals.determinant());
  for (const int i : {0, 1, 2}) {
    const Vector3d along = normals.row (i).cross (normals.row ((i + 1) % 3));
    if (!(volume >= min_sine * along.norm()))
      return {};
  }
  const Vector3d middle = (first.centroid + second.centroid + third.centroid) / 3.0;
  const Vector3d distances (signedDistance (middle, first),
                            signedDistance (middle, second),
                            signedDistance (middle, third));
  return middle - normals.partialPivLu().solve (distances);
}

bool
comesTo (const Meeting& meeting, const Vector3d& point)
{
  const double place = meeting.line.direction.dot (point - meeting.line.origin);
  return std::any_of (meeting.intervals.begin(),
                      meeting.intervals.end(),
                      [&] (const Interval& interval) {
                        return place >= interval.from - meeting.max_gap &&
                               place <= interval.to + meeting.max_gap;
                      });
}

/** \brief The points that three planes have in common, where an interval of each two of
 * them passes, or ends no farther off than their bridged gap; in ascending order.
 * \param[in] meetings in ascending order */
std::vector<PlaneCorner>
cornersOf (const std::vector<Meeting>& meetings,
           const std::vector<PlaneSegment>& planes,
           double min_sine)
{
  std::vector<PlaneCorner> corners;
  for (auto first = meetings.begin(); first != meetings.end(); ++first)
    for (auto next = first + 1; next != meetings.end() && next->first == first->first;
         ++next) {
      const auto [i, j, k] = std::tie (first->first, first->second, next->second);
      const auto last =
          std::find_if (next, meetings.end(), [j = j, k = k] (const Meeting& meeting) {
            return meeting.first == j && meeting.second == k;
          });
      if (last == meetings.end())
        continue;
      const auto point = meetingPoint (planes[i], planes[j], planes[k], min_sine);
      if (point && comesTo (*first, *point) && comesTo (*next, *point) &&
          comesTo (*last, *point))
        corners.push_back ({{i, j, k}, *point});
    }
  return corners;
}

/** \brief The nearest corner of a meeting that is no farther off than the bridged gap;
 * the end itself where there is none. */
Vector3d
drawn (const Vector3d& end,
       const Meeting& meeting,
       const std::vector<PlaneCorner>& corners)
{
  Vector3d nearest = end;
  double least = meeting.max_gap;
  for (const PlaneCorner& corner : corners) {
    const auto has = [&] (std::size_t plane) {
      return std::count (corner.planes.begin(), corner.planes.end(), plane) > 0;
    };
    const double distance = (corner.position - end).norm();
    if (distance <= least && has (meeting.first) && has (meeting.second)) {
      least = distance;
      nearest = corner.position;
    }
  }
  return nearest;
}

/** \brief An interval as an edge. Each end is drawn to a corner near it, if something
 * of the interval is left then; where both are near one corner, the nearer end. */
PlaneEdge
edgeOf (const Interval& interval,
        const Meeting& meeting,
        const std::vector<PlaneCorner>& corners)
{
  PlaneEdge edge;
  edge.planes = {meeting.first, meeting.second};
  edge.angle = meeting.angle;
  edge.from = meeting.line.at (interval.from);
  edge.to = meeting.line.at (interval.to);
  const Vector3d from = drawn (edge.from, meeting, corners);
  const Vector3d to = drawn (edge.to, meeting, corners);
  const auto is_edge = [&] (const Vector3d& begin, const Vector3d& end) {
    return meeting.line.direction.dot (end - begin) > 0.0;
  };
  const bool is_begin_nearer = (from - edge.from).norm() <= (to - edge.to).norm();
  const bool is_long = is_edge (from, to);
  if (is_long || (is_begin_nearer && is_edge (from, edge.to)))
    edge.from = from;
  if (is_long || (!is_begin_nearer && is_edge (edge.from, to)))
    edge.to = to;
  return edge;
}

bool
isLength (const std::optional<double>& number)
{
  return !number || (*number >= 0.0 && std::isfinite (*number));
}

std::string
validate (const CloudView& cloud, const std::vector<PlaneSegment>& planes)
{
  for (const PlaneSegment& plane : planes)
    for (const pcl::index_t index : plane.inliers)
      if (index < 0 || static_cast<std::size_t> (index) >= cloud.size)
        return "an inlier lies outside the cloud; give the one the planes are of";
  return {};
}

} // namespace

std::string
validate (const PlaneEdgeParameters& parameters)
{
  if (!isLength (parameters.reach))
    return "the reach must be a length from 0, or not be given";
  if (!isLength (parameters.max_gap))
    return "the bridged gap must be a length from 0, or not be given";
  if (!isLength (parameters.min_length))
    return "the smallest length must be a length from 0, or not be given";
  if (!(parameters.min_angle > 0.0 && parameters.min_angle <= right_angle))
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
  detail::throwOn (validate (cloud, planes));
  const std::vector<Meeting> meetings = meetingsOf (cloud, planes, parameters, shift);
  PlaneEdges found;
  found.corners = cornersOf (meetings, planes, std::sin (parameters.min_angle));
  for (const Meeting& meeting : meetings)
    for (const Interval& interval : meeting.intervals)
      found.edges.push_back (edgeOf (interval, meeting, found.corners));
  return found;
}

} // namespace pcl_ops

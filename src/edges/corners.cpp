// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges/corners.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace pcl_ops::internal {

namespace {

const Meeting*
meetingOf (const std::vector<Meeting>& meetings, std::size_t first, std::size_t second)
{
  const auto found =
      std::lower_bound (meetings.begin(),
                        meetings.end(),
                        std::tie (first, second),
                        [] (const Meeting& meeting, const auto& wanted) {
                          return std::tie (meeting.first, meeting.second) < wanted;
                        });
  const bool is_there =
      found != meetings.end() && found->first == first && found->second == second;
  return is_there ? &*found : nullptr;
}

bool
comesTo (const Meeting& meeting, const Eigen::Vector3d& point)
{
  const double place = meeting.line.placeOf (point);
  return std::any_of (meeting.intervals.begin(),
                      meeting.intervals.end(),
                      [&] (const Interval& interval) {
                        return place >= interval.from - meeting.max_gap &&
                               place <= interval.to + meeting.max_gap;
                      });
}

/** \brief The corners that lie on a meeting's line. */
std::vector<Eigen::Vector3d>
cornersOn (const Meeting& meeting, const std::vector<PlaneCorner>& corners)
{
  std::vector<Eigen::Vector3d> positions;
  for (const PlaneCorner& corner : corners) {
    const auto has = [&] (std::size_t plane) {
      return std::find (corner.planes.begin(), corner.planes.end(), plane) !=
             corner.planes.end();
    };
    if (has (meeting.first) && has (meeting.second))
      positions.push_back (corner.position);
  }
  return positions;
}

/** \brief The nearest of some positions; the end itself where none is near enough. */
Eigen::Vector3d
drawn (const Eigen::Vector3d& end,
       const std::vector<Eigen::Vector3d>& positions,
       double max_gap)
{
  Eigen::Vector3d nearest = end;
  double least = max_gap;
  for (const Eigen::Vector3d& position : positions)
    if ((position - end).norm() <= least) {
      least = (position - end).norm();
      nearest = position;
    }
  return nearest;
}

/** \brief Draws the ends to the corners near them; where both are near one corner, the
 * nearer end. */
void
drawToCorners (const Meeting& meeting,
               const std::vector<Eigen::Vector3d>& positions,
               PlaneEdge& edge)
{
  const Eigen::Vector3d from = drawn (edge.from, positions, meeting.max_gap);
  const Eigen::Vector3d to = drawn (edge.to, positions, meeting.max_gap);
  const auto is_edge = [&] (const Eigen::Vector3d& begin, const Eigen::Vector3d& end) {
    return meeting.line.direction.dot (end - begin) > 0.0;
  };
  const bool is_begin_nearer = (from - edge.from).norm() <= (to - edge.to).norm();
  if (is_edge (from, to)) {
    edge.from = from;
    edge.to = to;
  }
  else if (is_begin_nearer && is_edge (from, edge.to))
    edge.from = from;
  else if (!is_begin_nearer && is_edge (edge.from, to))
    edge.to = to;
}

} // namespace

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
      const Meeting* const last = meetingOf (meetings, j, k);
      const std::optional<Eigen::Vector3d> point =
          last == nullptr ? std::nullopt
                          : meetingPoint (planes[i], planes[j], planes[k], min_sine);
      if (point && comesTo (*first, *point) && comesTo (*next, *point) &&
          comesTo (*last, *point))
        corners.push_back ({{i, j, k}, *point});
    }
  return corners;
}

std::vector<PlaneEdge>
edgesOf (const Meeting& meeting, const std::vector<PlaneCorner>& corners)
{
  const std::vector<Eigen::Vector3d> positions = cornersOn (meeting, corners);
  std::vector<PlaneEdge> edges;
  for (const Interval& interval : meeting.intervals) {
    PlaneEdge edge;
    edge.planes = {meeting.first, meeting.second};
    edge.angle = meeting.angle;
    edge.from = meeting.line.at (interval.from);
    edge.to = meeting.line.at (interval.to);
    drawToCorners (meeting, positions, edge);
    edges.push_back (edge);
  }
  return edges;
}

} // namespace pcl_ops::internal

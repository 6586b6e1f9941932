// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges/corners.h"
#include "edges/meetings.h"
#include "geometry/angles.h"
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_edges.h>

#include <cmath>

namespace pcl_ops {

namespace {

using namespace internal;

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
    for (const PlaneEdge& edge : edgesOf (meeting, found.corners))
      found.edges.push_back (edge);
  return found;
}

} // namespace pcl_ops

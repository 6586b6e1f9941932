// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "labels.h"

#include <algorithm>

namespace pcl_ops::evaluation {

PlaneLabels
labelsOf (const std::vector<pcl::PointIndices>& planes, std::size_t points)
{
  PlaneLabels labels (points, 0);
  for (std::size_t plane = 0; plane < planes.size(); ++plane)
    for (const pcl::index_t i : planes[plane].indices)
      labels[static_cast<std::size_t> (i)] = static_cast<std::uint32_t> (plane + 1);
  return labels;
}

PlaneIds
planeIds (const PlaneLabels& labels)
{
  PlaneIds ids;
  ids.label = labels;
  std::sort (ids.label.begin(), ids.label.end());
  ids.label.erase (std::unique (ids.label.begin(), ids.label.end()), ids.label.end());
  if (!ids.label.empty() && ids.label.front() == 0)
    ids.label.erase (ids.label.begin());
  ids.points.assign (ids.label.size(), 0);
  ids.of_point.reserve (labels.size());
  for (const std::uint32_t label : labels) {
    if (label == 0) {
      ids.of_point.push_back (PlaneIds::none);
      continue;
    }
    const auto found = std::lower_bound (ids.label.begin(), ids.label.end(), label);
    const auto id = static_cast<std::uint32_t> (found - ids.label.begin());
    ids.of_point.push_back (id);
    ++ids.points[id];
  }
  return ids;
}

void
dropSmallPlanes (PlaneLabels& labels, std::size_t min_points)
{
  const PlaneIds ids = planeIds (labels);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0 && ids.points[ids.of_point[i]] < min_points)
      labels[i] = 0;
}

std::vector<PlaneSegment>
planesOf (const XyzCloud& cloud,
          const PlaneIds& planes,
          const ClassParameters& parameters)
{
  const Eigen::Vector3d sensor = cloud.sensor_origin_.head<3>().cast<double>();
  std::vector<Moments> moments (planes.size());
  std::vector<PlaneSegment> segments (planes.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint32_t id = planes.of_point[i];
    if (id == PlaneIds::none)
      continue;
    const Eigen::Vector3d point = cloud[i].getVector3fMap().cast<double>();
    if (moments[id].count == 0.0)
      moments[id].origin = point;
    const Eigen::Vector3d local = point - moments[id].origin;
    moments[id].add (local.x(), local.y(), local.z());
    segments[id].inliers.push_back (static_cast<pcl::index_t> (i));
  }
  for (std::size_t id = 0; id < segments.size(); ++id) {
    PlaneSegment& segment = segments[id];
    segment.centroid = moments[id].centroid();
    segment.moments = moments[id].about (segment.centroid);
    if (const std::optional<PlaneFit> fit = fitPlane (moments[id])) {
      const Eigen::Vector3d& normal = fit->plane.normal;
      segment.normal = fit->plane.distance (sensor) < 0.0 ? -normal : normal;
      segment.orientation = orientationOf (normal, parameters.up, parameters.tolerance);
    }
  }
  return segments;
}

} // namespace pcl_ops::evaluation

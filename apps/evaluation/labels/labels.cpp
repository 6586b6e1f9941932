// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "labels.h"

#include <algorithm>
#include <numeric>

namespace pcl_ops::evaluation {

namespace {

std::vector<Moments>
momentsOfPlanes (const XyzCloud& cloud, const PlaneIds& planes)
{
  std::vector<Moments> moments (planes.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (planes.of_point[i] == PlaneIds::none)
      continue;
    Moments& plane = moments[planes.of_point[i]];
    const Eigen::Vector3d point = cloud[i].getVector3fMap().cast<double>();
    if (plane.count == 0.0)
      plane.origin = point;
    const Eigen::Vector3d local = point - plane.origin;
    plane.add (local.x(), local.y(), local.z());
  }
  return moments;
}

} // namespace

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

void
sortBySize (PlaneLabels& labels)
{
  const PlaneIds planes = planeIds (labels);
  std::vector<std::uint32_t> largest_first (planes.size());
  std::iota (largest_first.begin(), largest_first.end(), 0);
  std::stable_sort (largest_first.begin(),
                    largest_first.end(),
                    [&] (std::uint32_t a, std::uint32_t b) {
                      return planes.points[a] > planes.points[b];
                    });
  std::vector<std::uint32_t> new_label (planes.size());
  for (std::uint32_t rank = 0; rank < largest_first.size(); ++rank)
    new_label[largest_first[rank]] = rank + 1;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0)
      labels[i] = new_label[planes.of_point[i]];
}

std::vector<PlaneSegment>
planesOf (const XyzCloud& cloud,
          const PlaneIds& planes,
          const ClassParameters& parameters)
{
  const Eigen::Vector3d sensor = cloud.sensor_origin_.head<3>().cast<double>();
  std::vector<PlaneSegment> segments;
  for (const Moments& moments : momentsOfPlanes (cloud, planes)) {
    PlaneSegment segment;
    segment.centroid = moments.centroid();
    if (const std::optional<PlaneFit> fit = fitPlane (moments)) {
      const Eigen::Vector3d& normal = fit->plane.normal;
      segment.normal = fit->plane.distance (sensor) < 0.0 ? -normal : normal;
      segment.orientation = orientationOf (normal, parameters.up, parameters.tolerance);
    }
    segment.moments = moments.about (segment.centroid);
    segments.push_back (segment);
  }
  for (std::size_t i = 0; i < planes.of_point.size(); ++i)
    if (planes.of_point[i] != PlaneIds::none)
      segments[planes.of_point[i]].inliers.push_back (static_cast<pcl::index_t> (i));
  return segments;
}

std::vector<Orientation>
pointClasses (const XyzCloud& cloud,
              const PlaneLabels& labels,
              const ClassParameters& parameters)
{
  const PlaneIds planes = planeIds (labels);
  const std::vector<PlaneSegment> segments = planesOf (cloud, planes, parameters);
  std::vector<Orientation> classes;
  classes.reserve (labels.size());
  for (const std::uint32_t plane : planes.of_point)
    classes.push_back (plane == PlaneIds::none ? Orientation::Other
                                               : segments[plane].orientation);
  return classes;
}

} // namespace pcl_ops::evaluation

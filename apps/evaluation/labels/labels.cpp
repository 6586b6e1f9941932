// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "labels.h"

#include <pcl/common/point_tests.h>

#include <map>

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

pcl::Indices
finitePointsOf (const XyzCloud& cloud)
{
  pcl::Indices finite;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (pcl::isXYZFinite (cloud[i]))
      finite.push_back (static_cast<pcl::index_t> (i));
  return finite;
}

PlaneLabels
selectLabels (const PlaneLabels& labels, const pcl::Indices& points)
{
  PlaneLabels selected;
  for (const pcl::index_t i : points)
    selected.push_back (labels[static_cast<std::size_t> (i)]);
  return selected;
}

PlaneIds
planeIds (const PlaneLabels& labels)
{
  std::map<std::uint32_t, std::uint32_t> id_of;
  for (const std::uint32_t label : labels)
    id_of[label] = PlaneIds::none;
  PlaneIds ids;
  for (auto& [label, id] : id_of)
    if (label != 0) {
      id = static_cast<std::uint32_t> (ids.size());
      ids.label.push_back (label);
    }
  ids.points.resize (ids.size());
  for (const std::uint32_t label : labels) {
    ids.of_point.push_back (id_of[label]);
    if (label != 0)
      ++ids.points[ids.of_point.back()];
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
  std::vector<PlaneSegment> segments (planes.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (planes.of_point[i] == PlaneIds::none)
      continue;
    PlaneSegment& segment = segments[planes.of_point[i]];
    const Eigen::Vector3d point = cloud[i].getVector3fMap().cast<double>();
    if (segment.inliers.empty())
      segment.moments.origin = point;
    addTo (segment.moments, point);
    segment.inliers.push_back (static_cast<pcl::index_t> (i));
  }
  const Eigen::Vector3d sensor = cloud.sensor_origin_.head<3>().cast<double>();
  for (PlaneSegment& segment : segments) {
    if (const std::optional<PlaneFit> fit = fitPlane (segment.moments)) {
      const Eigen::Vector3d& normal = fit->plane.normal;
      segment.normal = fit->plane.distance (sensor) < 0.0 ? -normal : normal;
      segment.orientation = orientationOf (normal, parameters.up, parameters.tolerance);
    }
    segment.centroid = segment.moments.centroid();
    segment.moments = segment.moments.about (segment.centroid);
  }
  return segments;
}

Confusion
confusionOf (const PlaneLabels& truth, const PlaneLabels& result)
{
  Confusion confusion{planeIds (truth), planeIds (result)};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> points_of_pair;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    confusion.points_off_planes += truth[i] == 0;
    confusion.points_on_no_plane_in_both += truth[i] == 0 && result[i] == 0;
    if (truth[i] != 0 && result[i] != 0)
      ++points_of_pair[{confusion.truth.of_point[i], confusion.result.of_point[i]}];
  }
  for (const auto& [pair, points] : points_of_pair)
    confusion.overlaps.push_back ({pair.first, pair.second, points});
  return confusion;
}

} // namespace pcl_ops::evaluation

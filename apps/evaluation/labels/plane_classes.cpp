// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_classes.h"

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

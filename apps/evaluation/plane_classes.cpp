// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_classes.h"

#include <pcl_ops/plane.h>

namespace pcl_ops::evaluation {

namespace {

std::vector<Moments>
momentsOfPlanes (const Cloud& cloud, const PlaneIds& planes)
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

std::vector<Orientation>
pointClasses (const Cloud& cloud,
              const Labels& labels,
              const ClassParameters& parameters)
{
  const PlaneIds planes = planeIds (labels);
  std::vector<Orientation> class_of_plane;
  for (const Moments& moments : momentsOfPlanes (cloud, planes)) {
    const std::optional<PlaneFit> fit = fitPlane (moments);
    class_of_plane.push_back (
        fit ? orientationOf (fit->plane.normal, parameters.up, parameters.tolerance)
            : Orientation::Other);
  }
  std::vector<Orientation> classes;
  classes.reserve (labels.size());
  for (const std::uint32_t plane : planes.of_point)
    classes.push_back (plane == PlaneIds::none ? Orientation::Other
                                               : class_of_plane[plane]);
  return classes;
}

} // namespace pcl_ops::evaluation

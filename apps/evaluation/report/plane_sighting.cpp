// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_sighting.h"

#include <cmath>

namespace pcl_ops::evaluation {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::optional<PlaneSighting>
sightingOf (const apps::XyzCloud& cloud,
            const PlaneSegment& plane,
            const Eigen::Isometry3d& pose)
{
  std::optional<PlaneCovariance> covariance = planeCovariance (cloud, plane);
  if (!covariance)
    return std::nullopt;
  covariance->axes = pose.linear() * covariance->axes;
  return PlaneSighting{
      pose * plane.centroid, pose.linear() * plane.normal, *covariance};
}

void
NormalizedErrors::add (const PlaneSighting& first, const PlaneSighting& second)
{
  const Eigen::Matrix<double, 3, 2>& axes = first.covariance.axes;
  const Vector3d between = second.centroid - first.centroid;
  const double cosine = second.normal.dot (first.normal);
  const Eigen::Vector2d slopes = -axes.transpose() * second.normal / cosine;
  // Heights a + b s + c t of the first where the second's centroid is; slopes of the
  // second along the axes of the first, its height along the normal of the first.
  Matrix3d of_first = Matrix3d::Identity();
  of_first.bottomLeftCorner<1, 2>() = (axes.transpose() * between).transpose();
  Matrix3d of_second = Matrix3d::Identity();
  of_second.topLeftCorner<2, 2>() = axes.transpose() * second.covariance.axes;
  const Matrix3d covariance =
      of_first * first.covariance.matrix * of_first.transpose() +
      of_second * second.covariance.matrix * of_second.transpose();
  const Vector3d sigmas = covariance.diagonal().cwiseSqrt();
  for (const Eigen::Index axis : {0, 1})
    tilts.push_back (std::abs (slopes[axis]) / sigmas[axis]);
  offsets.push_back (std::abs (first.normal.dot (between)) / sigmas[2]);
}

} // namespace pcl_ops::evaluation

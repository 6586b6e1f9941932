// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "geometry/angles.h"
#include "geometry/plane_axes.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_ops {

using namespace internal;

Moments&
Moments::operator+= (const Moments& other)
{
  if (count == 0.0)
    return *this = other;
  if (other.origin != origin)
    return *this += other.about (origin);
  addAligned (other);
  return *this;
}

Moments
Moments::about (const Eigen::Vector3d& new_origin) const
{
  const Eigen::Vector3d shift = origin - new_origin;
  const Eigen::Matrix3d added = sum * shift.transpose() + shift * sum.transpose() +
                                count * shift * shift.transpose();
  Moments moved = *this;
  moved.origin = new_origin;
  moved.sum += count * shift;
  moved.products[0] += added (0, 0);
  moved.products[1] += added (0, 1);
  moved.products[2] += added (0, 2);
  moved.products[3] += added (1, 1);
  moved.products[4] += added (1, 2);
  moved.products[5] += added (2, 2);
  return moved;
}

std::optional<PlaneFit>
fitPlane (const Moments& moments)
{
  if (moments.count < 3.0)
    return std::nullopt;
  const Eigen::Matrix3d covariance = moments.covariance();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance);
  const Eigen::Vector3d variances = solver.eigenvalues().cwiseMax (0.0);
  // Rounding of the inputs (single precision) alone can give a line this much width.
  constexpr double smallest_width = 1e-5;
  if (!(variances[1] > smallest_width * smallest_width * variances[2]))
    return std::nullopt;
  PlaneFit fit;
  fit.centroid = moments.centroid();
  fit.variances = variances;
  fit.plane = planeThrough (fit.centroid, solver.eigenvectors().col (0));
  return fit;
}

double
PlaneSegment::rms() const
{
  return std::sqrt (std::max (0.0, normal.dot (moments.covariance() * normal)));
}

std::optional<PlaneCovariance>
planeCovariance (const PlaneSegment& plane)
{
  const double n = plane.moments.count;
  if (n < 4.0 || !fitPlane (plane.moments))
    return std::nullopt;
  PlaneCovariance covariance;
  covariance.axes = planeAxes (plane.normal);
  // A^T A / n; s and t are taken from the centroid, so that their means are 0.
  const Eigen::Matrix2d spread =
      covariance.axes.transpose() * plane.moments.covariance() * covariance.axes;
  const double rms = plane.rms();
  const double residual_variance = rms * rms * n / (n - 3.0);
  covariance.matrix.setZero();
  covariance.matrix.topLeftCorner<2, 2>() = residual_variance / n * spread.inverse();
  covariance.matrix (2, 2) = residual_variance / n;
  return covariance;
}

bool
nameOrientations (std::vector<PlaneSegment>& planes,
                  const Eigen::Vector3d& up,
                  double tolerance)
{
  if (!up.allFinite() || up.isZero (0.0) ||
      !(tolerance >= 0.0 && tolerance <= right_angle))
    return false;
  const Eigen::Vector3d unit = up.stableNormalized();
  for (PlaneSegment& plane : planes)
    plane.orientation = orientationOf (plane.normal, unit, tolerance);
  return true;
}

} // namespace pcl_ops

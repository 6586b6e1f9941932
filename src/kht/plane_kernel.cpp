// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kht/plane_kernel.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {
namespace {

// Keeps the Jacobian finite at the poles and for planes through the center [m^2].
constexpr double smallest_squared_distance = 1e-5;

// Added to the variance of rho [m^2].
constexpr double min_rho_variance = 1e-5;

} // namespace

PlaneKernel
planeKernel (const Plane& plane,
             const Eigen::Vector3d& centroid,
             const Eigen::Matrix3d& covariance,
             const Eigen::Vector3d& center,
             double weight)
{
  const double signed_rho = (centroid - center).dot (plane.normal);
  const Eigen::Vector3d normal =
      signed_rho < 0.0 ? Eigen::Vector3d (-plane.normal) : plane.normal;
  const double rho = std::abs (signed_rho);
  const double theta = std::atan2 (normal.y(), normal.x());
  const double horizontal = std::hypot (normal.x(), normal.y());
  const double guard = std::sqrt (smallest_squared_distance);

  // p = rho n, w = px^2 + py^2, q = w + pz^2. The rows are written with the cosine and
  // sine of theta for px / sqrt (w) and py / sqrt (w), which stay defined at the poles.
  const double root_w = std::max (rho * horizontal, guard);
  const double root_q = std::max (rho, guard);
  Eigen::Matrix3d jacobian;
  jacobian.row (0) = normal;
  jacobian.row (1) << std::cos (theta) * normal.z(), std::sin (theta) * normal.z(),
      -horizontal;
  jacobian.row (1) /= root_q;
  jacobian.row (2) << -std::sin (theta) / root_w, std::cos (theta) / root_w, 0.0;

  PlaneKernel kernel;
  const double phi = std::acos (std::clamp (normal.z(), -1.0, 1.0));
  kernel.mean = Eigen::Vector3d (rho, phi, theta);
  kernel.covariance = jacobian * covariance * jacobian.transpose();
  kernel.covariance (0, 0) += min_rho_variance;
  kernel.weight = weight;
  return kernel;
}

} // namespace pcl_ops::internal

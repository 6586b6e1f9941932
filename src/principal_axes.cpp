// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "principal_axes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

namespace {

// Smallest root of x^3 - trace x^2 + minors x - determinant by Newton's method. Without
// its cubic term the polynomial has a root just above, which for flat sets of points is
// near enough to start from.
double
smallestRoot (double trace, double minors, double determinant)
{
  constexpr int most_steps = 60;
  const auto slopeAt = [&] (double root) {
    return (3.0 * root - 2.0 * trace) * root + minors;
  };
  const double precision = 1e-13 * trace;
  const double discriminant =
      std::max (0.0, minors * minors - 4.0 * trace * determinant);
  double root = 2.0 * determinant / (minors + std::sqrt (discriminant));
  // Zero is on the near side of all roots, if far away.
  if (!(slopeAt (root) > 0.25 * minors))
    root = 0.0;
  for (int i = 0; i < most_steps; ++i) {
    const double value = ((root - trace) * root + minors) * root - determinant;
    const double slope = slopeAt (root);
    if (!(slope > 0.0))
      break;
    const double step = value / slope;
    root -= step;
    if (std::abs (step) <= precision)
      break;
  }
  return std::max (0.0, root);
}

// The direction both remaining rows of a rank two matrix are perpendicular to.
Eigen::Vector3d
nullDirection (const Eigen::Matrix3d& matrix)
{
  const Eigen::Vector3d candidates[] = {matrix.row (0).cross (matrix.row (1)),
                                        matrix.row (1).cross (matrix.row (2)),
                                        matrix.row (2).cross (matrix.row (0))};
  const Eigen::Vector3d& longest =
      *std::max_element (std::begin (candidates),
                         std::end (candidates),
                         [] (const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                           return a.squaredNorm() < b.squaredNorm();
                         });
  return longest;
}

} // namespace

PrincipalAxes
principalAxes (const Eigen::Matrix3d& matrix)
{
  PrincipalAxes axes;
  const double scale = matrix.trace();
  if (!(scale > 0.0))
    return axes;
  const Eigen::Matrix3d m = (1.0 / scale) * matrix;
  const double minors = m (0, 0) * m (1, 1) - m (0, 1) * m (0, 1) +
                        m (0, 0) * m (2, 2) - m (0, 2) * m (0, 2) +
                        m (1, 1) * m (2, 2) - m (1, 2) * m (1, 2);
  const double smallest = smallestRoot (1.0, minors, m.determinant());
  const double sum = 1.0 - smallest;
  const double product = std::max (0.0, minors - smallest * sum);
  const double largest =
      0.5 * (sum + std::sqrt (std::max (0.0, sum * sum - 4.0 * product)));
  axes.values = scale * Eigen::Vector3d (smallest, product / largest, largest);
  const Eigen::Vector3d direction =
      nullDirection (m - smallest * Eigen::Matrix3d::Identity());
  // Below this the rows are parallel to within rounding.
  constexpr double smallest_norm = 1e-13;
  if (direction.norm() > smallest_norm)
    axes.normal = direction.normalized();
  return axes;
}

} // namespace pcl_ops

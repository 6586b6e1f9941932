// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "geometry/angles.h"
#include "geometry/principal_axes.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl_ops {
using namespace internal;
namespace {

/** \brief Adds a symmetric matrix to \ref Moments::products, which hold the upper
 * triangle row by row. */
void
addUpper (const Eigen::Matrix3d& matrix, std::array<double, 6>& products)
{
  std::size_t product = 0;
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = row; column < 3; ++column)
      products[product++] += matrix (row, column);
}

} // namespace

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
Moments::of (double count,
             const Eigen::Vector3d& mean,
             const Eigen::Matrix3d& covariance)
{
  Moments moments{mean, count};
  addUpper (count * covariance, moments.products);
  return moments;
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
  addUpper (added, moved.products);
  return moved;
}

std::optional<PlaneFit>
fitPlane (const Moments& moments)
{
  if (moments.count < 3.0)
    return std::nullopt;
  const Eigen::Matrix3d covariance = moments.covariance();
  internal::PrincipalAxes axes = internal::principalAxes (covariance);
  const Eigen::Vector3d& variances = axes.values;
  // Least width over length of a set of points for the closed form. Its smallest
  // variance has an error of some 1e-16 L^4 / W^2 for length L and width W: at this
  // limit 1 % of W^2, and in narrower sets soon all digits. If the two smallest
  // variances are equal, as for a ball or a rod, its normal is zero.
  constexpr double min_width_of_closed_form = 3e-4;
  if (axes.normal.isZero() || axes.values[1] < min_width_of_closed_form *
                                                   min_width_of_closed_form *
                                                   axes.values[2]) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance);
    axes = {solver.eigenvectors().col (0), solver.eigenvalues().cwiseMax (0.0)};
  }
  // Equal points that were summed about a remote origin have a covariance of rounding.
  const double rounding = moments.count * std::numeric_limits<double>::epsilon() *
                          (moments.centroid() - moments.origin).squaredNorm();
  if (!(variances[2] > rounding))
    return std::nullopt;
  // Rounding of coordinates to single precision gives a line nearly this much width.
  constexpr double min_width_over_length = 1e-5;
  if (!(variances[1] > min_width_over_length * min_width_over_length * variances[2]))
    return std::nullopt;
  const Eigen::Vector3d centroid = moments.centroid();
  return PlaneFit{planeThrough (centroid, axes.normal), centroid, variances};
}

double
PlaneSegment::rms() const
{
  const double variance = normal.dot (moments.covariance() * normal);
  // The plane need not contain the centroid of the moments.
  const double offset = normal.dot (moments.centroid() - centroid);
  return std::sqrt (std::max (0.0, variance + offset * offset));
}

const char*
toString (Orientation orientation)
{
  const bool is_horizontal = orientation == Orientation::Horizontal;
  const bool is_vertical = orientation == Orientation::Vertical;
  return is_horizontal ? "horizontal" : is_vertical ? "vertical" : "other";
}

Orientation
orientationOf (const Eigen::Vector3d& normal,
               const Eigen::Vector3d& up,
               double tolerance)
{
  const double cosine = std::min (1.0, std::abs (normal.dot (up)));
  if (std::acos (cosine) <= tolerance)
    return Orientation::Horizontal;
  const double from_vertical = std::asin (cosine); // of the plane [rad]
  if (from_vertical <= tolerance)
    return Orientation::Vertical;
  return Orientation::Other;
}

double
slopeOf (const Eigen::Vector3d& normal, const Eigen::Vector3d& up)
{
  // Use sine and cosine: the sine alone is inaccurate near 90 degrees, the cosine alone
  // is inaccurate near 0.
  return std::atan2 (normal.cross (up).norm(), std::abs (normal.dot (up)));
}

bool
nameOrientations (std::vector<PlaneSegment>& planes,
                  const Eigen::Vector3d& up,
                  double tolerance)
{
  if (!up.allFinite() || up.isZero (0.0) ||
      !(tolerance >= 0.0 && tolerance <= max_right_angle))
    return false;
  const Eigen::Vector3d unit_up = up.stableNormalized();
  for (PlaneSegment& plane : planes)
    plane.orientation = orientationOf (plane.normal, unit_up, tolerance);
  return true;
}

} // namespace pcl_ops

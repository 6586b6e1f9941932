// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "kht/plane_kernel.h"

#include <cmath>

using namespace pcl_ops::internal;

namespace {

using pcl_ops::planeThrough;

/** rho, phi and theta of the plane whose point nearest to the center is p. */
Eigen::Vector3d
sphericalOf (const Eigen::Vector3d& p)
{
  return Eigen::Vector3d (
      p.norm(), std::acos (p.z() / p.norm()), std::atan2 (p.y(), p.x()));
}

Eigen::Matrix3d
jacobianAt (const Eigen::Vector3d& p)
{
  constexpr double step = 1e-6;
  Eigen::Matrix3d jacobian;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d moved = step * Eigen::Vector3d::Unit (axis);
    jacobian.col (axis) =
        (sphericalOf (p + moved) - sphericalOf (p - moved)) / (2.0 * step);
  }
  return jacobian;
}

const Eigen::Vector3d center (1.0, 2.0, 3.0);
const Eigen::Vector3d normal = Eigen::Vector3d (0.3, -0.5, 0.7).normalized();
const Eigen::Vector3d centroid = center + Eigen::Vector3d (1.0, 0.2, 0.9);

Eigen::Matrix3d
someCovariance ()
{
  Eigen::Matrix3d root;
  root << 0.1, 0.02, 0.0, 0.0, 0.2, 0.05, 0.03, 0.0, 0.15;
  return root * root.transpose();
}

PlaneKernel
kernelOf (const Eigen::Vector3d& with_normal)
{
  return planeKernel (
      planeThrough (centroid, with_normal), centroid, someCovariance(), center, 0.5);
}

} // namespace

TEST (PlaneKernel, LiesAtThePlaneSeenFromTheCenter)
{
  const double rho = (centroid - center).dot (normal);
  EXPECT_LT ((kernelOf (normal).mean - sphericalOf (rho * normal)).norm(), 1e-12);
  EXPECT_EQ (kernelOf (normal).weight, 0.5);
}

TEST (PlaneKernel, DoesNotDependOnTheNormalsSign)
{
  EXPECT_EQ (kernelOf (normal).mean, kernelOf (-normal).mean);
  EXPECT_EQ (kernelOf (normal).covariance, kernelOf (-normal).covariance);
}

TEST (PlaneKernel, CarriesThePointsCovarianceOver)
{
  const Eigen::Vector3d p = (centroid - center).dot (normal) * normal;
  const Eigen::Matrix3d jacobian = jacobianAt (p);
  Eigen::Matrix3d expected = jacobian * someCovariance() * jacobian.transpose();
  expected (0, 0) += 1e-5;
  EXPECT_LT ((kernelOf (normal).covariance - expected).norm(), 1e-6 * expected.norm());
}

TEST (PlaneKernel, IsFiniteAtThePolesAndThroughTheCenter)
{
  for (const Eigen::Vector3d& direction : {Eigen::Vector3d::UnitZ().eval(),
                                           Eigen::Vector3d (-Eigen::Vector3d::UnitZ()),
                                           normal})
    for (const double rho : {1.0, 0.0}) {
      const Eigen::Vector3d point = center + rho * direction;
      const PlaneKernel kernel = planeKernel (
          planeThrough (point, direction), point, someCovariance(), center, 1.0);
      EXPECT_TRUE (kernel.mean.allFinite());
      EXPECT_GT (kernel.covariance.determinant(), 0.0);
    }
}

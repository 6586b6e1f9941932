// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "geometry/principal_axes.h"
#include "scene.h"

using namespace pcl_ops::internal;

namespace {

/** \brief A matrix with these eigenvalues along random axes. */
Eigen::Matrix3d
turned (const Eigen::Vector3d& values, RandomGenerator& generator)
{
  const Eigen::Quaterniond turn = Eigen::Quaterniond (drawNormal (generator),
                                                      drawNormal (generator),
                                                      drawNormal (generator),
                                                      drawNormal (generator))
                                      .normalized();
  return turn * values.asDiagonal() * turn.conjugate();
}

} // namespace

TEST (PrincipalAxes, AgreeWithEigensIterativeSolver)
{
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 200; ++i) {
    const double width = std::pow (10.0, -3.0 * drawUnit (generator));
    // Every tenth is an exact plane.
    const double noise = i % 10 == 0 ? 0.0 : 0.9 * width * drawUnit (generator);
    const Eigen::Matrix3d matrix = turned ({noise, width, 1.0}, generator);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> oracle (matrix);
    const PrincipalAxes axes = principalAxes (matrix);
    EXPECT_LT (angleBetween (axes.normal, oracle.eigenvectors().col (0)), 1e-7);
    EXPECT_TRUE (axes.values.isApprox (oracle.eigenvalues(), 1e-8));
  }
}

TEST (PrincipalAxes, DoNotDependOnTheUnitOfLength)
{
  RandomGenerator generator (seedOfTest());
  const Eigen::Matrix3d matrix = turned ({0.01, 0.3, 1.0}, generator);
  for (const double scale : {1e-12, 1e12}) {
    const PrincipalAxes axes = principalAxes (scale * matrix);
    EXPECT_LT (angleBetween (axes.normal, principalAxes (matrix).normal), 1e-12);
    EXPECT_NEAR (axes.values[2], scale, 1e-9 * scale);
  }
}

TEST (PrincipalAxes, HaveTwoValuesOfZeroForALine)
{
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 200; ++i) {
    const Eigen::Matrix3d line = turned ({0.0, 0.0, 1e12}, generator);
    const Eigen::Vector3d values = principalAxes (line).values;
    // Double roots are found to half the digits.
    EXPECT_TRUE (values.isApprox (Eigen::Vector3d (0.0, 0.0, 1e12), 1e-6))
        << values.transpose();
  }
}

TEST (PrincipalAxes, HaveNoNormalForAPointAndForNumbersThatAreNone)
{
  EXPECT_TRUE (principalAxes (Eigen::Matrix3d::Zero()).normal.isZero());
  for (const double none : {HUGE_VAL, std::nan ("")})
    EXPECT_TRUE (principalAxes (Eigen::Matrix3d::Constant (none)).normal.isZero());
}

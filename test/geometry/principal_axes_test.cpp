// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>

#include "geometry/principal_axes.h"
#include "scene.h"

using namespace pcl_ops::internal;

namespace {

/** \brief A symmetric matrix with these eigenvalues and with random eigenvectors. */
Eigen::Matrix3d
matrixWith (const Eigen::Vector3d& values, RandomGenerator& generator)
{
  const Eigen::Quaterniond turn = drawTurn (generator);
  return turn * values.asDiagonal() * turn.conjugate();
}

} // namespace

TEST (PrincipalAxes, AgreeWithEigensIterativeSolverInAnyUnitOfLength)
{
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 200; ++i) {
    // From a thousandth of the largest value, 1, to that value.
    const double middle_value = std::pow (10.0, -3.0 * drawUnit (generator));
    // Every tenth matrix is that of an exact plane: its least eigenvalue is 0.
    const double least_value =
        i % 10 == 0 ? 0.0 : 0.9 * middle_value * drawUnit (generator);
    // The square of a unit of length, from 1e-12 to 1e12.
    const double scale = std::pow (10.0, 24.0 * drawUnit (generator) - 12.0);
    const Eigen::Matrix3d matrix =
        scale * matrixWith ({least_value, middle_value, 1.0}, generator);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> oracle (matrix);
    const PrincipalAxes axes = principalAxes (matrix);
    EXPECT_NEAR (axes.normal.norm(), 1.0, 1e-12);
    EXPECT_LT (angleBetween (axes.normal, oracle.eigenvectors().col (0)), 1e-7);
    EXPECT_TRUE (axes.values.isApprox (oracle.eigenvalues(), 1e-8));
    EXPECT_GE (axes.values.minCoeff(), 0.0) << "rounding makes no variance negative";
  }
}

TEST (PrincipalAxes, HaveTwoValuesOfZeroForALine)
{
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 200; ++i) {
    const Eigen::Matrix3d line = matrixWith ({0.0, 0.0, 1e12}, generator);
    const Eigen::Vector3d values = principalAxes (line).values;
    // A double root of the characteristic polynomial is found to half of the digits.
    EXPECT_TRUE (values.isApprox (Eigen::Vector3d (0.0, 0.0, 1e12), 1e-6))
        << values.transpose();
    EXPECT_GE (values.minCoeff(), 0.0) << "rounding makes no variance negative";
  }
}

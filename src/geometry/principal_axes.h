// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace pcl_ops::internal {

/** \brief What a plane fit needs of a symmetric, positive semi-definite matrix. */
struct PrincipalAxes {
  /** \brief Unit eigenvector of the smallest eigenvalue; zero where that is no single
   * direction (rank one or less). */
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  /** \brief Ascending eigenvalues. */
  Eigen::Vector3d values = Eigen::Vector3d::Zero();
};

/** \brief Principal axes of many matrices, several at a time.
 *
 * Closed form but for the smallest eigenvalue, which Newton's method finds from a
 * start near it: the characteristic polynomial is concave there, so that from the
 * second step on it comes from below and cannot overshoot. For the flat sets of
 * interest two or three steps suffice.
 * \param[out] axes zero for a matrix without a positive trace */
void
principalAxes (const Eigen::Matrix3d* matrices,
               std::size_t number,
               PrincipalAxes* axes);

PrincipalAxes
principalAxes (const Eigen::Matrix3d& matrix);

} // namespace pcl_ops::internal

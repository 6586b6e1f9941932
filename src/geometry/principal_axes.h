// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace pcl_ops::internal {

/** \brief Eigenvalues and the smallest eigenvector of a symmetric, positive
 * semi-definite matrix: all that a plane fit needs of a covariance. */
struct PrincipalAxes {
  /** \brief Unit eigenvector of the smallest eigenvalue, with either sign; zero if the
   * two smallest eigenvalues are equal to within rounding: then unit eigenvectors of
   * many directions exist. */
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  /** \brief Ascending eigenvalues, none below 0. */
  Eigen::Vector3d values = Eigen::Vector3d::Zero();
};

/** \brief Computes the principal axes of \p count matrices, several at a time.
 *
 * The smallest eigenvalue comes from Newton's method, the rest is in closed form.
 * Newton's method starts near the smallest root of the characteristic polynomial, which
 * is concave there: after the first step it approaches the root from below and cannot
 * overshoot. For flat sets of points two or three steps suffice. Eight successive
 * matrices take equally many steps, so that the last digits may depend on the others.
 * \param[out] axes one for each matrix; all zero for a matrix without a positive trace
 */
void
principalAxes (const Eigen::Matrix3d* matrices, std::size_t count, PrincipalAxes* axes);

/** \brief Computes the principal axes of one matrix. */
PrincipalAxes
principalAxes (const Eigen::Matrix3d& matrix);

} // namespace pcl_ops::internal

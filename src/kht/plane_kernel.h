// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/plane.h>

namespace pcl_ops::internal {

/** \brief A trivariate Gaussian over planes, in the order rho [m], phi [rad], theta
 * [rad] (Limberger & Oliveira 2015, section 3.2). */
struct PlaneKernel {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  /** \brief Factor of its density. */
  double weight = 1.0;
};

/** \brief The kernel of a set of points near a plane: the points' covariance carried
 * over to the plane's parameters, Sigma_rpt = J Sigma_xyz J^T, plus 1e-5 on (rho, rho).
 * \param[in] plane the points' plane; the sign of its normal means nothing
 * \param[in] centroid the points' centroid
 * \param[in] covariance Sigma_xyz, the points' population covariance
 * \param[in] center center of the ball, in the same frame
 * \param[in] weight factor of its density */
PlaneKernel
planeKernel (const Plane& plane,
             const Eigen::Vector3d& centroid,
             const Eigen::Matrix3d& covariance,
             const Eigen::Vector3d& center,
             double weight);

} // namespace pcl_ops::internal

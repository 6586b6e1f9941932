// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "paper/ball_directions.h"
#include <pcl_ops/plane.h>

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief A trivariate Gaussian over the plane parameters rho [m], phi [rad] and theta
 * [rad], in this order (Limberger & Oliveira 2015, section 3.2). */
struct PlaneKernel {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  /** \brief Factor that its density is multiplied by. */
  double weight = 1.0;
};

/** \brief The kernel of a set of points near a plane: the points' covariance propagated
 * to the plane parameters, Sigma_rpt = J Sigma_xyz J^T, plus 1e-5 m^2 on the variance
 * of rho.
 * \param[in] fit the plane of the points; the sign of its normal has no effect
 * \param[in] covariance Sigma_xyz, the points' population covariance
 * \param[in] center of the ball, in the frame of \p fit
 * \param[in] weight see \ref PlaneKernel::weight */
PlaneKernel
planeKernel (const PlaneFit& fit,
             const Eigen::Matrix3d& covariance,
             const Eigen::Vector3d& center,
             double weight);

/** \brief A kernel's votes along rho in one direction. */
struct VoteRay {
  std::uint32_t direction = 0;
  /** \brief Its range of rho bins, [begin, end). */
  std::int32_t begin = 0, end = 0;
  /** \brief Index of its first vote in \ref KernelVotes::values. */
  std::uint32_t first_value = 0;
};

/** \brief All votes of a kernel. */
struct KernelVotes {
  std::vector<VoteRay> rays;
  /** \brief The votes of all rays, ray by ray. */
  std::vector<float> values;
};

/** \brief Computes the votes of a kernel for the bins whose center lies in its
 * ellipsoid of two standard deviations, on which the density is g_min = exp (-2) times
 * its peak. Votes also end 8 rows from the mean, 8 patches from the likeliest azimuth
 * of a row and 32 bins from the likeliest rho of a direction, so that a kernel has at
 * most some 20,000 votes: 17 rows of 17 patches with 65 bins each.
 *
 * A vote is weight times the density at the bin's center. The bin that contains the
 * mean gets at least weight times g_min, so that a kernel between bin centers is not
 * lost. Rows beyond a pole continue on its other side, half a turn farther. Negative
 * rho is positive rho in the opposite direction. Votes beyond the last rho are dropped.
 * A kernel counts once per bin, with its largest vote: where its rays overlap around a
 * pole or the center, the smaller vote becomes 0. Kernels whose covariance is not
 * positive definite have no votes.
 * \param[out] votes overwritten; its memory is reused */
void
castVotes (const PlaneKernel& kernel, const HoughSpace& space, KernelVotes& votes);

} // namespace pcl_ops::internal

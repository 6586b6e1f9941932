// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "paper/ball_directions.h"
#include <pcl_ops/plane.h>

#include <cstdint>
#include <vector>

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
 * \param[in] fit the sign of its normal means nothing
 * \param[in] covariance Sigma_xyz, the points' population covariance
 * \param[in] center of the ball, in the same frame */
PlaneKernel
planeKernel (const PlaneFit& fit,
             const Eigen::Matrix3d& covariance,
             const Eigen::Vector3d& center,
             double weight);

/** \brief A kernel's votes along rho in one direction. */
struct VoteRay {
  std::uint32_t direction = 0;
  /** \brief Its bins are those from begin to before end. */
  std::int32_t begin = 0, end = 0;
  /** \brief Where its values begin in \ref KernelVotes::values. */
  std::uint32_t first_value = 0;
};

struct KernelVotes {
  std::vector<VoteRay> rays;
  std::vector<float> values;
};

/** \brief Votes for the bins whose center lies within two standard deviations of a
 * kernel, within the ellipsoid on which its density is g_min = exp (-2) of its peak,
 * and within 8 directions and 32 bins of rho, so that no kernel costs more than some
 * 20,000.
 *
 * The vote is weight times the density at the bin's center. The kernel's own bin gets
 * at least the vote weight g_min, so that a kernel that lies between bin centers is not
 * lost. Rows beyond a pole are those of the pole's other side, half a turn on; negative
 * rho is positive rho in the opposite direction; votes beyond the last rho are dropped.
 * A kernel counts once per bin, with its largest vote: where its votes meet themselves
 * around a pole or the center, the smaller is 0. Only kernels with a positive definite
 * covariance have votes.
 * \param[out] votes overwritten; its memory is used again */
void
castVotes (const PlaneKernel& kernel, const HoughSpace& space, KernelVotes& votes);

} // namespace pcl_ops::internal

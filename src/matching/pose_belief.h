// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "matching/patch.h"

namespace pcl_ops::internal {

/** \brief How the second of two patches lies over the first. */
struct Mismatch {
  using Jacobian = Eigen::Matrix<double, 3, 6>;

  /** \brief Slopes along the two axes of the first, and the height of the second's
   * centre over it [m]. */
  Eigen::Vector3d heights;
  /** \brief Covariance of \ref heights by what both patches are off. */
  Eigen::Matrix3d covariance;
  /** \brief How they change with a rotation vector about the origin of the second's
   * frame, and a shift. */
  Jacobian by_motion;
};

/** \brief What is known of the pose of a frame in another: a pose, and the covariance
 * of its error, a rotation vector [rad] about the frame's origin and a shift [m], both
 * along the axes of the other. */
class PoseBelief {
public:
  using Covariance = Eigen::Matrix<double, 6, 6>;

  PoseBelief (const Eigen::Isometry3d& pose,
              double rotation_error,
              double translation_error);

  const Eigen::Isometry3d&
  pose () const
  {
    return pose_;
  }

  /** \param[in] fixed in the other frame
   * \param[in] seen in the frame of the pose, on the side of \p fixed or not */
  Mismatch
  mismatchOf (const Patch& fixed, const Patch& seen) const;

  /** \brief The squared Mahalanobis distance: what both patches and the pose may be off
   * explains a mismatch the better, the smaller it is. */
  double
  squaredDistance (const Mismatch& mismatch) const;

  /** \brief Lets the pose follow from two patches that are one plane (the update of an
   * iterated extended Kalman filter). */
  void
  update (const Patch& fixed, const Patch& seen);

private:
  Eigen::Isometry3d pose_;
  Covariance covariance_;
};

} // namespace pcl_ops::internal

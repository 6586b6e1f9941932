// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/pose_belief.h"

#include <Eigen/Cholesky>

namespace pcl_ops::internal {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/** \brief Covariance of (slope along, slope across, height) of a patch over its axes,
 * at its centre. Neighboring points err alike and surfaces are not quite flat, so that
 * a mean over all points is no better than one of them: \ref planeCovariance without
 * its division by the number of points. */
Matrix3d
covarianceOf (const Patch& patch)
{
  // Coordinates in single precision.
  constexpr double rounding = 1e-5;
  const double size = patch.half.maxCoeff();
  const double noise = patch.noise + rounding * rounding * size * size;
  const Eigen::Array2d spread = patch.half.array().square() / 3.0;
  const Eigen::Array2d slopes = noise / spread;
  return Vector3d (slopes.x(), slopes.y(), noise).asDiagonal();
}

/** \brief The parameters over other axes, at a place that many meters along the old. */
Matrix3d
transfer (const Eigen::Matrix2d& turn, const Eigen::Vector2d& place)
{
  Matrix3d result = Matrix3d::Identity();
  result.topLeftCorner<2, 2>() = turn;
  result.bottomLeftCorner<1, 2>() = place.transpose();
  return result;
}

/** \param[in] motion a rotation vector about the frame's origin and a shift */
Eigen::Isometry3d
turnedAndShifted (Eigen::Isometry3d pose, const Eigen::Matrix<double, 6, 1>& motion)
{
  const Vector3d rotation = motion.head<3>();
  const double angle = rotation.norm();
  if (angle > 0.0)
    pose.linear() =
        Eigen::AngleAxisd (angle, rotation / angle).toRotationMatrix() * pose.linear();
  pose.translation() += motion.tail<3>();
  return pose;
}

} // namespace

PoseBelief::PoseBelief (const Eigen::Isometry3d& pose,
                        double rotation_error,
                        double translation_error)
: pose_ (pose), covariance_ (Covariance::Zero())
{
  covariance_.topLeftCorner<3, 3>().diagonal().setConstant (rotation_error *
                                                            rotation_error);
  covariance_.bottomRightCorner<3, 3>().diagonal().setConstant (translation_error *
                                                                translation_error);
}

Mismatch
PoseBelief::mismatchOf (const Patch& fixed, const Patch& seen) const
{
  const Patch over = moved (pose_, seen);
  const Eigen::Matrix<double, 3, 2> axes = fixed.axes.leftCols<2>();
  const Vector3d normal = fixed.normal();
  const Vector3d between = over.center - fixed.center;
  Mismatch mismatch;
  // Which side was seen does not matter: no sign to turn.
  const Eigen::Vector2d slopes =
      -axes.transpose() * over.normal() / over.normal().dot (normal);
  mismatch.heights << slopes, normal.dot (between);
  const Matrix3d of_fixed =
      transfer (Eigen::Matrix2d::Identity(), axes.transpose() * between);
  const Matrix3d of_seen =
      transfer (axes.transpose() * over.axes.leftCols<2>(), Eigen::Vector2d::Zero());
  mismatch.covariance = of_fixed * covarianceOf (fixed) * of_fixed.transpose() +
                        of_seen * covarianceOf (seen) * of_seen.transpose();
  const Vector3d lever = over.center - pose_.translation();
  mismatch.by_motion.setZero();
  mismatch.by_motion.row (0).head<3>() = -normal.cross (axes.col (0));
  mismatch.by_motion.row (1).head<3>() = -normal.cross (axes.col (1));
  mismatch.by_motion.row (2) << lever.cross (normal).transpose(), normal.transpose();
  return mismatch;
}

double
PoseBelief::squaredDistance (const Mismatch& mismatch) const
{
  const Matrix3d covariance = mismatch.covariance + mismatch.by_motion * covariance_ *
                                                        mismatch.by_motion.transpose();
  return mismatch.heights.dot (covariance.ldlt().solve (mismatch.heights));
}

void
PoseBelief::update (const Patch& fixed, const Patch& seen)
{
  constexpr int iterations = 3; // a turn of 20 degrees is not linear
  const Eigen::Isometry3d before = pose_;
  Eigen::Matrix<double, 6, 1> motion = Eigen::Matrix<double, 6, 1>::Zero();
  Covariance explained;
  for (int i = 0; i < iterations; ++i) {
    const Mismatch mismatch = mismatchOf (fixed, seen);
    const Mismatch::Jacobian& jacobian = mismatch.by_motion;
    const Matrix3d covariance =
        mismatch.covariance + jacobian * covariance_ * jacobian.transpose();
    const Eigen::Matrix<double, 6, 3> gain =
        covariance.ldlt().solve (jacobian * covariance_).transpose();
    motion = -gain * (mismatch.heights - jacobian * motion);
    pose_ = turnedAndShifted (before, motion);
    explained = gain * jacobian * covariance_;
  }
  covariance_ -= explained;
  covariance_ = 0.5 * (covariance_ + covariance_.transpose()).eval();
}

} // namespace pcl_ops::internal

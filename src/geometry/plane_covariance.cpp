// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/inliers.h"
#include "geometry/planar_area.h"
#include "geometry/plane_statistics.h"
#include <pcl_ops/plane.h>

#include <cmath>
#include <map>
#include <utility>

namespace pcl_ops {
using namespace internal;
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/** \brief Indices of a square block of the plane along both axes: whole numbers. They
 * are no integers, as blocks of far inliers have indices beyond these. */
using Block = std::pair<double, double>;

/** \brief For each block with inliers the sum of (s, t, 1) h over these, with their
 * coordinates s and t in the plane and their height h over it [m]. */
using BlockSums = std::map<Block, Vector3d>;

/** \brief The side of a block is the square root of the plane's area, divided by this
 * number. So a plane has some 64 blocks. On planes of usual size they are far larger
 * than the range of correlated sensor errors. */
constexpr double blocks_per_side = 8.0;

// Adds up the inliers of each block.
// \param[in] axes of the plane, PlaneCovariance::axes
// \param[in] side of a block [m]
BlockSums
blockSums (const CloudView& cloud,
           const PlaneSegment& plane,
           const Eigen::Matrix<double, 3, 2>& axes,
           double side)
{
  BlockSums sums;
  for (const pcl::index_t i : plane.inliers) {
    const float* const point = cloud[i];
    const Vector3d offset = Vector3d (point[0], point[1], point[2]) - plane.centroid;
    if (!offset.allFinite())
      continue;
    const Eigen::Vector2d s_and_t = axes.transpose() * offset;
    const Eigen::Array2d block = (s_and_t / side).array().floor();
    Vector3d& sum =
        sums.try_emplace ({block.x(), block.y()}, Vector3d::Zero()).first->second;
    sum += plane.normal.dot (offset) * Vector3d (s_and_t.x(), s_and_t.y(), 1.0);
  }
  return sums;
}

/** \brief Covariance of the coordinates s and t of the inliers in the plane [m^2]. */
Eigen::Matrix2d
spreadOf (const PlaneSegment& plane, const Eigen::Matrix<double, 3, 2>& axes)
{
  return axes.transpose() * plane.moments.covariance() * axes;
}

} // namespace

std::optional<PlaneCovariance>
independentPlaneCovariance (const PlaneSegment& plane)
{
  const double n = plane.moments.count;
  if (n < parameters_of_plane + 1.0 || !fitPlane (plane.moments))
    return std::nullopt;
  PlaneCovariance covariance;
  covariance.axes = planeAxes (plane.normal);
  // The upper left part of A^T A / n, with A of the description of
  // independentPlaneCovariance. The coordinates s and t start at the centroid, so that
  // their means are 0.
  const Eigen::Matrix2d spread = spreadOf (plane, covariance.axes);
  const double rms = plane.rms();
  const double residual_variance = rms * rms * n / (n - parameters_of_plane);
  covariance.matrix.setZero();
  covariance.matrix.topLeftCorner<2, 2>() = residual_variance / n * spread.inverse();
  covariance.matrix (2, 2) = residual_variance / n;
  return covariance;
}

std::optional<PlaneCovariance>
planeCovariance (const CloudView& cloud, const PlaneSegment& plane)
{
  checkInliers (cloud, plane);
  std::optional<PlaneCovariance> covariance = independentPlaneCovariance (plane);
  if (!covariance)
    return std::nullopt;
  const double n = plane.moments.count;
  const Eigen::Matrix2d spread = spreadOf (plane, covariance->axes);
  // The area of a rectangle of evenly spread points with this covariance.
  const double area =
      squared_width_of_variance * std::sqrt (std::max (0.0, spread.determinant()));
  if (!(area > 0.0))
    return std::nullopt;
  const BlockSums sums =
      blockSums (cloud, plane, covariance->axes, std::sqrt (area) / blocks_per_side);
  const auto block_count = static_cast<double> (sums.size());
  if (block_count < parameters_of_plane + 1.0)
    return std::nullopt;
  Matrix3d sum_of_products = Matrix3d::Zero();
  for (const auto& [block, sum] : sums)
    sum_of_products += sum * sum.transpose();
  // (A^T A)^-1 of the description of planeCovariance.
  Matrix3d inverse = Matrix3d::Identity() / n;
  inverse.topLeftCorner<2, 2>() = spread.inverse() / n;
  // f of the description of planeCovariance: true errors over estimated ones, measured
  // on planes of simulated depth images that were matched by exact poses.
  constexpr double measured_factor = 1.7;
  covariance->matrix = measured_factor * measured_factor * block_count /
                       (block_count - parameters_of_plane) * inverse * sum_of_products *
                       inverse;
  return covariance;
}

} // namespace pcl_ops

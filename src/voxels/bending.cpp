// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/bending.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

using Terms = Eigen::Matrix<double, 6, 1>;

// Normal equations of the fit of heights [m]; u and v in units of the half extents.
struct Equations {
  Eigen::Matrix<double, 6, 6> squares = Eigen::Matrix<double, 6, 6>::Zero();
  Terms products = Terms::Zero();
  double squared_heights = 0.0;

  void
  add (double weight, double u, double v, double height)
  {
    Terms terms;
    terms << 1.0, u, v, u * u, u * v, v * v;
    squares += weight * terms * terms.transpose();
    products += weight * height * terms;
    squared_heights += weight * height * height;
  }

  /** \brief Residual sum of squares of the fit by the first \p number terms [m^2]. */
  template <int number>
  double
  left () const
  {
    const Eigen::Matrix<double, number, number> a =
        squares.topLeftCorner<number, number>();
    const Eigen::Matrix<double, number, 1> b = products.head<number>();
    const Eigen::Matrix<double, number, 1> x = a.ldlt().solve (b);
    return std::max (0.0, squared_heights - b.dot (x));
  }
};

// The principal axes u and v in the plane of a patch. The half extents [m] are those of
// an evenly covered rectangle with the moments of the patch.
struct PatchAxes {
  Eigen::Vector3d u, v;
  double half_u, half_v;
};

PatchAxes
axesOf (const Moments& moments, const Plane& plane)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes (moments.covariance());
  const Eigen::Vector3d half_extents =
      std::sqrt (3.0) * axes.eigenvalues().cwiseMax (1e-300).cwiseSqrt();
  const Eigen::Vector3d u = axes.eigenvectors().col (2);
  return {u, plane.normal.cross (u), half_extents[2], half_extents[1]};
}

} // namespace

Bending
bendingOf (const VoxelGrid& grid, const Indices& voxels, const PlaneFit& fit)
{
  Bending bending;
  constexpr std::size_t min_voxels = 8;
  if (voxels.size() < min_voxels)
    return bending;
  const std::vector<Moments>& moments = grid.moments;
  const PatchAxes axes = axesOf (momentsOf (moments, voxels), fit.plane);
  Equations equations;
  for (const std::uint32_t voxel : voxels) {
    const Eigen::Vector3d offset = moments[voxel].centroid() - fit.centroid;
    const double height = fit.plane.normal.dot (offset);
    equations.add (moments[voxel].count,
                   axes.u.dot (offset) / axes.half_u,
                   axes.v.dot (offset) / axes.half_v,
                   height);
  }
  const auto number = static_cast<double> (voxels.size());
  const double flat = equations.left<3>();
  const double curved = equations.left<6>();
  if (flat > 0.0)
    bending.explained = 1.0 - (curved / (number - 6.0)) / (flat / (number - 3.0));
  const Terms x = equations.squares.ldlt().solve (equations.products);
  Eigen::Matrix2d second_order;
  second_order << x[3], 0.5 * x[4], 0.5 * x[4], x[5];
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> bends;
  bends.computeDirect (second_order); // compute() takes four seconds to compile
  const int largest =
      std::abs (bends.eigenvalues()[0]) > std::abs (bends.eigenvalues()[1]) ? 0 : 1;
  const Eigen::Vector2d direction = bends.eigenvectors().col (largest);
  bending.amplitude = std::abs (bends.eigenvalues()[largest]);
  bending.half_extent =
      1.0 / std::hypot (direction[0] / axes.half_u, direction[1] / axes.half_v);
  return bending;
}

bool
isCurved (const Bending& bending)
{
  constexpr double smallest_share = 0.4;
  constexpr double smallest_slope = 0.01;
  return bending.explained > smallest_share &&
         bending.amplitude > smallest_slope * bending.half_extent;
}

} // namespace pcl_ops::internal

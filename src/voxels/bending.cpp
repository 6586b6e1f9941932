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

// Numbers of terms of the flat fit and of the curved fit. Further ones are of second
// order.
constexpr int terms_of_flat = 3;   // 1, u, v
constexpr int terms_of_curved = 6; // and u^2, u v, v^2

// Normal equations A x = b of the fit of heights [m] by the six terms, with A = matrix
// and b = right_side; u and v are in units of the half extents.
struct NormalEquations {
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Terms right_side = Terms::Zero();
  /** \brief Weighted sum of the squared heights [m^2]. */
  double squared_heights = 0.0;

  void
  add (double weight, double u, double v, double height)
  {
    Terms terms;
    terms << 1.0, u, v, u * u, u * v, v * v;
    matrix += weight * terms * terms.transpose();
    right_side += weight * height * terms;
    squared_heights += weight * height * height;
  }

  /** \brief Residual sum of squares of the fit by the first \p terms terms [m^2]. */
  template <int terms>
  double
  residualSumOfSquares () const
  {
    const Eigen::Matrix<double, terms, terms> a = matrix.topLeftCorner<terms, terms>();
    const Eigen::Matrix<double, terms, 1> b = right_side.head<terms>();
    const Eigen::Matrix<double, terms, 1> x = a.ldlt().solve (b);
    return std::max (0.0, squared_heights - b.dot (x));
  }
};

// The principal axes of a patch in its plane: u along its length, v along its width.
// The half extents [m] are those of an evenly covered rectangle with the moments of the
// patch.
struct PatchAxes {
  Eigen::Vector3d u, v;
  double half_u, half_v;
};

PatchAxes
axesOf (const Moments& moments, const Plane& plane)
{
  // Above 0, as positions along u and v are divided by half extents.
  constexpr double min_variance = 1e-300;
  // Eigenvalues ascend: along the normal, along v, along u.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes (moments.covariance());
  // A rectangle of half extent h has the variance h^2 / 3.
  const Eigen::Vector3d half_extents =
      std::sqrt (3.0) * axes.eigenvalues().cwiseMax (min_variance).cwiseSqrt();
  const Eigen::Vector3d u = axes.eigenvectors().col (2);
  return {u, plane.normal.cross (u), half_extents[2], half_extents[1]};
}

NormalEquations
equationsOf (const std::vector<Moments>& moments,
             const Indices& voxels,
             const PlaneFit& fit,
             const PatchAxes& axes)
{
  NormalEquations equations;
  for (const std::uint32_t voxel : voxels) {
    const Eigen::Vector3d offset = moments[voxel].centroid() - fit.centroid;
    const double height = fit.plane.normal.dot (offset);
    equations.add (moments[voxel].count,
                   axes.u.dot (offset) / axes.half_u,
                   axes.v.dot (offset) / axes.half_v,
                   height);
  }
  return equations;
}

// Adjusted R^2 of the second-order terms. The degrees of freedom of a residual variance
// are the number of voxels minus the number of terms.
double
explainedShare (const NormalEquations& equations, double voxel_count)
{
  const double flat_squares = equations.residualSumOfSquares<terms_of_flat>();
  const double curved_squares = equations.residualSumOfSquares<terms_of_curved>();
  if (!(flat_squares > 0.0))
    return 0.0;
  return 1.0 - (curved_squares / (voxel_count - terms_of_curved)) /
                   (flat_squares / (voxel_count - terms_of_flat));
}

} // namespace

Bending
bendingOf (const VoxelGrid& grid, const Indices& voxels, const PlaneFit& fit)
{
  Bending bending;
  // Two more than terms_of_curved: so many terms explain fewer voxels by chance.
  constexpr std::size_t min_voxels = 8;
  if (voxels.size() < min_voxels)
    return bending;
  const PatchAxes axes = axesOf (momentsOf (grid.moments, voxels), fit.plane);
  const NormalEquations equations = equationsOf (grid.moments, voxels, fit, axes);
  bending.explained_share =
      explainedShare (equations, static_cast<double> (voxels.size()));
  const Terms coefficients = equations.matrix.ldlt().solve (equations.right_side);
  const double u_squared = coefficients[3];
  const double half_mixed = 0.5 * coefficients[4];
  const double v_squared = coefficients[5];
  Eigen::Matrix2d quadratic_form;
  quadratic_form << u_squared, half_mixed, half_mixed, v_squared;
  // Eigenvalues are the second-order heights [m] at the half extents along the axes.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> bends;
  bends.computeDirect (quadratic_form); // compute() takes four seconds to compile
  const int largest =
      std::abs (bends.eigenvalues()[0]) > std::abs (bends.eigenvalues()[1]) ? 0 : 1;
  // In units of the half extents.
  const Eigen::Vector2d direction = bends.eigenvectors().col (largest);
  bending.amplitude = std::abs (bends.eigenvalues()[largest]);
  bending.half_extent =
      1.0 / std::hypot (direction[0] / axes.half_u, direction[1] / axes.half_v);
  return bending;
}

bool
isCurved (const Bending& bending)
{
  // Chosen by hand; src/doc/constants.csv has F without each of them.
  constexpr double min_explained_share = 0.4;
  constexpr double min_slope = 0.01; // of amplitude over half extent
  return bending.explained_share > min_explained_share &&
         bending.amplitude > min_slope * bending.half_extent;
}

} // namespace pcl_ops::internal

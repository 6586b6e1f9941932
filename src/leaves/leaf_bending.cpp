// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_bending.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_ops::internal {

namespace {

using BendTerms = Eigen::Matrix<double, 6, 1>;

/** \brief Normal equations of the fit: heights [m] over u and v in half extents. */
class BendEquations {
public:
  void
  add (double weight, double u, double v, double height)
  {
    const double powers_of_u[] = {1.0, u, u * u, u * u * u, u * u * u * u};
    double weighted = weight; // by a power of v
    std::size_t sum = 0;
    for (int of_v = 0; of_v < 5; ++of_v) {
      for (int of_u = 0; of_u < 5 - of_v; ++of_u) {
        sums_[sum] += weighted * powers_of_u[of_u];
        ++sum;
      }
      weighted *= v;
    }
    BendTerms terms;
    terms << 1.0, u, v, u * u, u * v, v * v;
    products_ += weight * height * terms;
    squared_heights_ += weight * height * height;
  }

  const BendTerms&
  products () const
  {
    return products_;
  }

  double
  squaredHeights () const
  {
    return squared_heights_;
  }

  BendTerms
  solution () const
  {
    return squares().ldlt().solve (products_);
  }

  /** \brief Sum of squares that a plane of its own leaves. */
  double
  leftByPlane () const
  {
    const Eigen::Matrix3d a = squares().topLeftCorner<3, 3>();
    const Eigen::Vector3d b = products_.head<3>();
    return std::max (0.0, squared_heights_ - b.dot (a.ldlt().solve (b)));
  }

private:
  /** \brief The sum of weights times u^of_u v^of_v. */
  double
  sumOf (int of_u, int of_v) const
  {
    constexpr int first_of_power[] = {0, 5, 9, 12, 14};
    return sums_[first_of_power[of_v] + of_u];
  }

  Eigen::Matrix<double, 6, 6>
  squares () const
  {
    constexpr int of_u[] = {0, 1, 0, 2, 1, 0};
    constexpr int of_v[] = {0, 0, 1, 0, 1, 2};
    Eigen::Matrix<double, 6, 6> squares;
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column)
        squares (row, column) =
            sumOf (of_u[row] + of_u[column], of_v[row] + of_v[column]);
    return squares;
  }

  std::array<double, 15> sums_{};
  BendTerms products_ = BendTerms::Zero();
  double squared_heights_ = 0.0;
};

/** \brief The axes of leaves along their plane, with half the extent along each [m] as
 * if they were evenly covered. */
struct BendAxes {
  Eigen::Vector3d center, u, v;
  double half_u, half_v;
};

BendAxes
bendAxesOf (const Moments& moments, const Plane& plane)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes (moments.covariance());
  const Eigen::Vector3d half_extents =
      std::sqrt (3.0) * axes.eigenvalues().cwiseMax (1e-300).cwiseSqrt();
  const Eigen::Vector3d u = axes.eigenvectors().col (2);
  return {
      moments.centroid(), u, plane.normal.cross (u), half_extents[2], half_extents[1]};
}

// The larger principal bend of the second order terms, and its direction.
void
takeLargestBend (const BendTerms& terms, const BendAxes& axes, LeafBending& bending)
{
  Eigen::Matrix2d second_order;
  second_order << terms[3], 0.5 * terms[4], 0.5 * terms[4], terms[5];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> bends (second_order);
  const Eigen::Vector2d amplitudes = bends.eigenvalues().cwiseAbs();
  const int largest = amplitudes[0] > amplitudes[1] ? 0 : 1;
  const Eigen::Vector2d direction = bends.eigenvectors().col (largest);
  bending.amplitude = amplitudes[largest];
  bending.half_extent =
      1.0 / std::hypot (direction[0] / axes.half_u, direction[1] / axes.half_v);
}

} // namespace

LeafBending
bendingOfLeaves (const LeafCloud& cloud, const Indices& leaves, const Plane& plane)
{
  constexpr std::size_t min_leaves = 8;
  LeafBending bending;
  if (leaves.size() < min_leaves)
    return bending;
  // So many leaves tell the bend of a large plane, too.
  constexpr std::size_t enough = 500;
  const std::size_t step = leaves.size() / enough + 1;
  Moments all;
  for (std::size_t i = 0; i < leaves.size(); i += step)
    all.addAligned (cloud.moments[leaves[i]]);
  const BendAxes axes = bendAxesOf (all, plane);
  BendEquations equations;
  double squared_distances = 0.0;
  for (std::size_t i = 0; i < leaves.size(); i += step) {
    const Moments& moments = cloud.moments[leaves[i]];
    const Eigen::Vector3d offset = moments.centroid() - axes.center;
    equations.add (moments.count,
                   axes.u.dot (offset) / axes.half_u,
                   axes.v.dot (offset) / axes.half_v,
                   plane.normal.dot (offset));
    squared_distances += moments.count * meanSquaredDistance (moments, plane);
  }
  const BendTerms terms = equations.solution();
  const double gain =
      std::min (equations.squaredHeights(), equations.products().dot (terms));
  const double flat = equations.leftByPlane();
  bending.leaves = (leaves.size() + step - 1) / step;
  const auto number = static_cast<double> (bending.leaves);
  if (flat > 0.0)
    bending.explained = 1.0 - (equations.squaredHeights() - gain) /
                                  std::max (1.0, number - 6.0) /
                                  (flat / (number - 3.0));
  takeLargestBend (terms, axes, bending);
  bending.left = std::sqrt (std::max (0.0, squared_distances - gain) / all.count);
  return bending;
}

bool
isCurved (const LeafBending& bending)
{
  constexpr double min_share = 0.4;
  // At .01 real walls, bent by a sensor, go.
  constexpr double min_slope = 0.04;
  return bending.explained > min_share &&
         bending.amplitude > min_slope * bending.half_extent;
}

} // namespace pcl_ops::internal

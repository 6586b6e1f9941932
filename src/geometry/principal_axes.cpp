// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/principal_axes.h"

#include <algorithm>

namespace pcl_ops::internal {

namespace {

// Matrices side by side: every operation below is one on all of them.
constexpr std::size_t lanes = 8;
using Lanes = Eigen::Array<double, lanes, 1>;

struct SymmetricMatrices {
  Lanes xx, xy, xz, yy, yz, zz;
};

struct Directions {
  Lanes x, y, z;
};

struct Axes {
  Directions normal;
  Lanes smallest, middle, largest;
};

// Divides by the traces and returns them; 0 for a matrix without one.
inline Lanes
normalize (SymmetricMatrices& m)
{
  const Lanes trace = m.xx + m.yy + m.zz;
  const Lanes inverse = 1.0 / trace;
  for (Lanes* entry : {&m.xx, &m.xy, &m.xz, &m.yy, &m.yz, &m.zz})
    *entry = (trace > 0.0).select (inverse * *entry, 0.0);
  return (trace > 0.0).select (trace, 0.0);
}

// The trace is one: the smallest of three can be no more.
constexpr double largest_smallest = 1.0 / 3.0;

// Where Newton's method starts. Without its cubic term the polynomial has a root just
// above, which for flat sets of points is near enough; zero is on the near side of all
// roots, if far away.
inline Lanes
startOfRoots (const Lanes& minors, const Lanes& determinant)
{
  const Lanes discriminant = (minors * minors - 4.0 * determinant).max (0.0);
  const Lanes start = 2.0 * determinant / (minors + discriminant.sqrt());
  const Lanes slope = (3.0 * start - 2.0) * start + minors;
  return (start <= largest_smallest && slope > 0.25 * minors).select (start, 0.0);
}

// Smallest roots of x^3 - x^2 + minors x - determinant.
inline Lanes
smallestRoots (const Lanes& minors, const Lanes& determinant)
{
  constexpr int most_steps = 60;
  constexpr double precision = 1e-13;
  // Less steep it is a line's, whose two smallest roots are zero to within rounding.
  constexpr double least_slope = 1e-14;
  Lanes root = startOfRoots (minors, determinant), step = Lanes::Ones();
  for (int n = 0; n < most_steps && (step.abs() > precision).any(); ++n) {
    const Lanes value = ((root - 1.0) * root + minors) * root - determinant;
    const Lanes slope = (3.0 * root - 2.0) * root + minors;
    step = (slope > least_slope).select (value / slope, 0.0);
    root -= step;
  }
  return root.max (0.0).min (largest_smallest);
}

// The unit vectors all rows of rank two matrices are perpendicular to: the longest of
// the products of two rows; zero where the rows are parallel to within rounding.
inline Directions
nullDirections (const SymmetricMatrices& m)
{
  constexpr double smallest_norm = 1e-13;
  Directions longest{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
  Lanes squared = Lanes::Constant (-1.0);
  const auto take = [&] (const Lanes& x, const Lanes& y, const Lanes& z) {
    const Lanes other = x * x + y * y + z * z;
    const auto is_longer = (other > squared).eval();
    longest.x = is_longer.select (x, longest.x);
    longest.y = is_longer.select (y, longest.y);
    longest.z = is_longer.select (z, longest.z);
    squared = is_longer.select (other, squared);
  };
  take (
      m.xy * m.yz - m.xz * m.yy, m.xz * m.xy - m.xx * m.yz, m.xx * m.yy - m.xy * m.xy);
  take (
      m.yy * m.zz - m.yz * m.yz, m.yz * m.xz - m.xy * m.zz, m.xy * m.yz - m.yy * m.xz);
  take (
      m.yz * m.xz - m.zz * m.xy, m.zz * m.xx - m.xz * m.xz, m.xz * m.xy - m.yz * m.xx);
  const Lanes norm = squared.sqrt();
  const Lanes inverse = (norm > smallest_norm).select (1.0 / norm, 0.0);
  return {longest.x * inverse, longest.y * inverse, longest.z * inverse};
}

void
findAxes (SymmetricMatrices& m, Axes& axes)
{
  const Lanes scale = normalize (m);
  const Lanes yz = m.yy * m.zz - m.yz * m.yz;
  const Lanes minors = m.xx * m.yy - m.xy * m.xy + m.xx * m.zz - m.xz * m.xz + yz;
  const Lanes determinant = m.xx * yz + m.xy * (m.yz * m.xz - m.xy * m.zz) +
                            m.xz * (m.xy * m.yz - m.yy * m.xz);
  const Lanes smallest = smallestRoots (minors, determinant);
  const Lanes sum = 1.0 - smallest;
  const Lanes product = (minors - smallest * sum).max (0.0);
  const Lanes largest = 0.5 * (sum + (sum * sum - 4.0 * product).max (0.0).sqrt());
  axes.smallest = scale * smallest;
  axes.middle = scale * (product / largest);
  axes.largest = scale * largest;
  for (Lanes* entry : {&m.xx, &m.yy, &m.zz})
    *entry -= smallest;
  axes.normal = nullDirections (m);
}

} // namespace

void
principalAxes (const Eigen::Matrix3d* matrices, std::size_t number, PrincipalAxes* axes)
{
  for (std::size_t begin = 0; begin < number; begin += lanes) {
    SymmetricMatrices batch;
    Axes found;
    for (std::size_t i = 0; i < lanes; ++i) {
      const Eigen::Matrix3d& matrix = matrices[std::min (begin + i, number - 1)];
      batch.xx[i] = matrix (0, 0);
      batch.xy[i] = matrix (0, 1);
      batch.xz[i] = matrix (0, 2);
      batch.yy[i] = matrix (1, 1);
      batch.yz[i] = matrix (1, 2);
      batch.zz[i] = matrix (2, 2);
    }
    findAxes (batch, found);
    for (std::size_t i = 0; i < std::min (lanes, number - begin); ++i) {
      axes[begin + i].values = {found.smallest[i], found.middle[i], found.largest[i]};
      axes[begin + i].normal = {
          found.normal.x[i], found.normal.y[i], found.normal.z[i]};
    }
  }
}

PrincipalAxes
principalAxes (const Eigen::Matrix3d& matrix)
{
  PrincipalAxes axes;
  principalAxes (&matrix, 1, &axes);
  return axes;
}

} // namespace pcl_ops::internal

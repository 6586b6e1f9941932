// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/principal_axes.h"

#include "base/vectorized.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_ops::internal {
namespace {

// Eight matrices are processed side by side, one in each lane: the compiler vectorizes
// the loops over lanes.
constexpr std::size_t lanes = 8;
using Lanes = std::array<double, lanes>;

/** \brief The upper triangles of the matrices. */
struct SymmetricMatrices {
  Lanes xx, xy, xz, yy, yz, zz;
};

/** \brief The unit eigenvectors (x, y, z) of the smallest eigenvalues, and all
 * eigenvalues of the matrices. */
struct Axes {
  Lanes x, y, z;
  Lanes smallest, middle, largest;
};

// Eigenvalues are computed of matrices scaled to a trace of 1. Then their sum is 1, and
// the smallest one is at most this.
constexpr double max_smallest_root = 1.0 / 3.0;

// Returns the start of Newton's method for the smallest root of the characteristic
// polynomial x^3 - x^2 + minors x - determinant, where minors is the sum of the
// principal minors of order two. Without its cubic term the polynomial has a root just
// above the smallest one: for flat sets of points it is a good start. It is (minors -
// sqrt (minors^2 - 4 determinant)) / 2, written so that no digits cancel. For other
// sets the start is 0, which is below all roots but may be far away.
inline double
startOfRoot (double minors, double determinant)
{
  const double discriminant = std::max (0.0, minors * minors - 4.0 * determinant);
  const double start = 2.0 * determinant / (minors + std::sqrt (discriminant));
  const double slope = (3.0 * start - 2.0) * start + minors;
  // The slope is minors at x = 0, and 0 at the maximum between the smallest and the
  // middle root. From a start near that maximum a step of Newton's method leads far
  // off.
  constexpr double min_share_of_slope = 0.25; // chosen by hand
  const bool is_near_root =
      start <= max_smallest_root && slope > min_share_of_slope * minors;
  return is_near_root ? start : 0.0;
}

// Returns the smallest roots of x^3 - x^2 + minors x - determinant.
inline Lanes
smallestRoots (const Lanes& minors, const Lanes& determinant)
{
  constexpr double precision = 1e-13; // of a root
  // At a double root, as of a line or a rod, a step only halves the error: from 1/3 to
  // the precision takes log2 (1e13 / 3) = 42 steps.
  constexpr int max_steps = 60;
  // A smaller slope means a line: its two smallest roots are zero but for rounding.
  constexpr double min_slope = 1e-14;
  Lanes root;
  for (std::size_t i = 0; i < lanes; ++i)
    root[i] = startOfRoot (minors[i], determinant[i]);
  double largest_step = 1.0;
  for (int n = 0; n < max_steps && largest_step > precision; ++n) {
    largest_step = 0.0;
    for (std::size_t i = 0; i < lanes; ++i) {
      const double value =
          ((root[i] - 1.0) * root[i] + minors[i]) * root[i] - determinant[i];
      const double slope = (3.0 * root[i] - 2.0) * root[i] + minors[i];
      const double step = slope > min_slope ? value / slope : 0.0;
      root[i] -= step;
      largest_step = std::max (largest_step, std::abs (step));
    }
  }
  for (std::size_t i = 0; i < lanes; ++i)
    root[i] = std::min (std::max (0.0, root[i]), max_smallest_root);
  return root;
}

// The longest vector so far. Without branches, so that loops over lanes are vectorized.
struct LongestVector {
  double x;
  double y;
  double z;
  double squared_length;

  void
  take (double other_x, double other_y, double other_z)
  {
    const double other_squared_length =
        other_x * other_x + other_y * other_y + other_z * other_z;
    const bool is_longer = other_squared_length > squared_length;
    x = is_longer ? other_x : x;
    y = is_longer ? other_y : y;
    z = is_longer ? other_z : z;
    squared_length = is_longer ? other_squared_length : squared_length;
  }
};

// Finds the unit null vectors of matrices of rank two. Each is the longest cross
// product of two rows, normalized; zero if all rows are parallel to within rounding.
// \param[in] m matrices with entries of at most 1
inline void
findNormals (const SymmetricMatrices& m, Axes& axes)
{
  constexpr double min_norm = 1e-13; // far above the rounding of products, 1e-16
  for (std::size_t i = 0; i < lanes; ++i) {
    const double x = m.xy[i] * m.yz[i] - m.xz[i] * m.yy[i];
    const double y = m.xz[i] * m.xy[i] - m.xx[i] * m.yz[i];
    const double z = m.xx[i] * m.yy[i] - m.xy[i] * m.xy[i];
    LongestVector normal{x, y, z, x * x + y * y + z * z};
    normal.take (m.yy[i] * m.zz[i] - m.yz[i] * m.yz[i],
                 m.yz[i] * m.xz[i] - m.xy[i] * m.zz[i],
                 m.xy[i] * m.yz[i] - m.yy[i] * m.xz[i]);
    normal.take (m.yz[i] * m.xz[i] - m.zz[i] * m.xy[i],
                 m.zz[i] * m.xx[i] - m.xz[i] * m.xz[i],
                 m.xz[i] * m.xy[i] - m.yz[i] * m.xx[i]);
    const double norm = std::sqrt (normal.squared_length);
    const double inverse = norm > min_norm ? 1.0 / norm : 0.0;
    axes.x[i] = norm > min_norm ? normal.x * inverse : 0.0;
    axes.y[i] = norm > min_norm ? normal.y * inverse : 0.0;
    axes.z[i] = norm > min_norm ? normal.z * inverse : 0.0;
  }
}

// Finds the principal axes of all lanes.
// \param[in,out] m the matrices; overwritten
PCL_OPS_VECTORIZED
void
findAxes (SymmetricMatrices& m, Axes& axes)
{
  Lanes scale;
  Lanes minors;
  Lanes determinant;
  for (std::size_t i = 0; i < lanes; ++i) {
    const double trace = m.xx[i] + m.yy[i] + m.zz[i];
    scale[i] = trace > 0.0 ? trace : 0.0;
    const double inverse = trace > 0.0 ? 1.0 / trace : 0.0;
    for (Lanes* entry : {&m.xx, &m.xy, &m.xz, &m.yy, &m.yz, &m.zz})
      (*entry)[i] = trace > 0.0 ? inverse * (*entry)[i] : 0.0;
    const double minor_yz = m.yy[i] * m.zz[i] - m.yz[i] * m.yz[i];
    minors[i] = m.xx[i] * m.yy[i] - m.xy[i] * m.xy[i] + m.xx[i] * m.zz[i] -
                m.xz[i] * m.xz[i] + minor_yz;
    determinant[i] = m.xx[i] * minor_yz +
                     m.xy[i] * (m.yz[i] * m.xz[i] - m.xy[i] * m.zz[i]) +
                     m.xz[i] * (m.xy[i] * m.yz[i] - m.yy[i] * m.xz[i]);
  }
  const Lanes smallest = smallestRoots (minors, determinant);
  for (std::size_t i = 0; i < lanes; ++i) {
    // Sum and product of the two larger eigenvalues.
    const double sum = 1.0 - smallest[i];
    const double product = std::max (0.0, minors[i] - smallest[i] * sum);
    const double largest =
        0.5 * (sum + std::sqrt (std::max (0.0, sum * sum - 4.0 * product)));
    axes.smallest[i] = scale[i] * smallest[i];
    axes.middle[i] = scale[i] * (product / largest);
    axes.largest[i] = scale[i] * largest;
    for (Lanes* entry : {&m.xx, &m.yy, &m.zz})
      (*entry)[i] -= smallest[i];
  }
  findNormals (m, axes);
}

} // namespace

void
principalAxes (const Eigen::Matrix3d* matrices, std::size_t count, PrincipalAxes* axes)
{
  for (std::size_t begin = 0; begin < count; begin += lanes) {
    SymmetricMatrices batch;
    Axes found;
    for (std::size_t i = 0; i < lanes; ++i) {
      // Lanes behind the last matrix repeat it.
      const Eigen::Matrix3d& matrix = matrices[std::min (begin + i, count - 1)];
      batch.xx[i] = matrix (0, 0);
      batch.xy[i] = matrix (0, 1);
      batch.xz[i] = matrix (0, 2);
      batch.yy[i] = matrix (1, 1);
      batch.yz[i] = matrix (1, 2);
      batch.zz[i] = matrix (2, 2);
    }
    findAxes (batch, found);
    for (std::size_t i = 0; i < std::min (lanes, count - begin); ++i) {
      axes[begin + i].values = {found.smallest[i], found.middle[i], found.largest[i]};
      axes[begin + i].normal = {found.x[i], found.y[i], found.z[i]};
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

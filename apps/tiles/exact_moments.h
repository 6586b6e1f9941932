// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/config.hpp>

#include <Eigen/Core>

#include <pcl_ops/plane.h>

#include <cmath>

namespace pcl_ops::apps {

/** \brief Moments about zero of points that are rounded to a lattice with the spacing
 * \ref unit. They are integers, so that sums are exact, and the order of the points
 * does not matter.
 *
 * The integers do not overflow for 10^11 points at 10^7 m from zero, with a unit of a
 * ten thousandth of a decimeter. */
struct ExactMoments {
  using Int128 = boost::int128_type;

  /** \brief Spacing of the lattice [m], a power of two: rounding to the lattice is then
   * the only error. */
  double unit = 1.0;
  /** \brief Sum of p p^T over all points p = (x, y, z, 1), with x, y and z in units of
   * the lattice. */
  Eigen::Matrix<Int128, 4, 4> sums = Eigen::Matrix<Int128, 4, 4>::Zero();

  /** \brief Number of points. */
  Int128
  count () const
  {
    return sums (3, 3);
  }

  /** \brief Adds a point, rounded to the nearest point of the lattice.
   * \param[in] point [m] */
  void
  add (const Eigen::Vector3d& point)
  {
    const Eigen::Vector3d on_lattice = (point / unit).array().round();
    const Eigen::Matrix<Int128, 4, 1> p = on_lattice.homogeneous().cast<Int128>();
    sums += p * p.transpose();
  }

  /** \brief Returns the moments in meters. Their origin is a point of the lattice next
   * to the centroid. Returns zero moments if there are no points. */
  Moments
  toMoments () const
  {
    Moments moments;
    if (count() == 0)
      return moments;
    // Translates the points by the negative centroid, rounded by integer division.
    Eigen::Matrix<Int128, 4, 4> translation = Eigen::Matrix<Int128, 4, 4>::Identity();
    translation.col (3).head<3>() = sums.col (3).head<3>() / -count();
    const Eigen::Matrix<double, 4, 4> translated_sums =
        (translation * sums * translation.transpose()).cast<double>();
    moments.origin = -unit * translation.col (3).head<3>().cast<double>();
    moments.count = translated_sums (3, 3);
    moments.sum = unit * translated_sums.col (3).head<3>();
    const Eigen::Matrix3d products =
        unit * unit * translated_sums.topLeftCorner<3, 3>();
    double* upper_triangle = moments.products.data();
    for (int row = 0; row < 3; ++row)
      for (int column = row; column < 3; ++column)
        *upper_triangle++ = products (row, column);
    return moments;
  }
};

/** \brief Returns the unit of \ref ExactMoments for points in cells with this edge [m]:
 * the largest power of two that is at most a ten thousandth of the edge [m]. */
inline double
momentsUnit (double cell_edge)
{
  // Rounding then moves a point along an axis by less than a four-thousandth of the
  // usual spacing of points on a surface, which has 20 of them in a cell.
  constexpr double min_units_per_cell = 1e4;
  return std::exp2 (std::floor (std::log2 (cell_edge / min_units_per_cell)));
}

} // namespace pcl_ops::apps

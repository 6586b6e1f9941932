// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/config.hpp>

#include <Eigen/Core>

#include <pcl_ops/plane.h>

#include <cmath>

namespace pcl_ops::apps {

/** \brief Moments about zero of points rounded to a lattice of \ref unit, as integers.
 * Their sums are exact, so that the order of the points does not matter.
 *
 * The integers have room for 10^11 points at 10^7 m from zero, with cells of a
 * decimeter and a unit of a ten thousandth of a cell. */
struct ExactMoments {
  using Whole = boost::int128_type;

  /** \brief Spacing of the lattice [m], a power of two: rounding to the lattice is then
   * the only error. */
  double unit = 1.0;
  /** \brief Sum of p p^T over all points p = (x, y, z, 1) [unit]. */
  Eigen::Matrix<Whole, 4, 4> sums = Eigen::Matrix<Whole, 4, 4>::Zero();

  Whole
  count () const
  {
    return sums (3, 3);
  }

  /** \brief Adds a point, rounded to the nearest lattice place. \param[in] place [m] */
  void
  add (const Eigen::Vector3d& place)
  {
    const Eigen::Vector3d on_lattice = (place / unit).array().round();
    const Eigen::Matrix<Whole, 4, 1> p = on_lattice.homogeneous().cast<Whole>();
    sums += p * p.transpose();
  }

  /** \brief The moments in meters, about a lattice place next to the centroid; zero if
   * there are no points. */
  Moments
  toMoments () const
  {
    Moments moments;
    if (count() == 0)
      return moments;
    Eigen::Matrix<Whole, 4, 4> move = Eigen::Matrix<Whole, 4, 4>::Identity();
    move.col (3).head<3>() = sums.col (3).head<3>() / -count();
    const Eigen::Matrix<double, 4, 4> moved =
        (move * sums * move.transpose()).cast<double>();
    moments.origin = -unit * move.col (3).head<3>().cast<double>();
    moments.count = moved (3, 3);
    moments.sum = unit * moved.col (3).head<3>();
    const Eigen::Matrix3d products = unit * unit * moved.topLeftCorner<3, 3>();
    double* product = moments.products.data();
    for (int i = 0; i < 3; ++i)
      for (int k = i; k < 3; ++k)
        *product++ = products (i, k);
    return moments;
  }
};

/** \brief The largest power of two up to a ten thousandth of a cell [m]. */
inline double
latticeFor (double cell)
{
  constexpr double units_of_cell = 1e4;
  return std::exp2 (std::floor (std::log2 (cell / units_of_cell)));
}

} // namespace pcl_ops::apps

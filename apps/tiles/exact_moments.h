// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/config.hpp>

#include <Eigen/Core>

#include <pcl_ops/plane.h>

#include <array>
#include <cstdint>

namespace pcl_ops::apps {

/** \brief The moments of points on a lattice of \ref unit, in whole numbers about zero:
 * sums of them are those of all their points, whatever was added first.
 *
 * With units of a ten thousandth of a cell there is room for 10^11 points 10^7 m from
 * zero and cells of a decimeter. */
struct ExactMoments {
  using Whole = boost::int128_type;

  /** \brief Edge of the lattice [m], a power of two: places become multiples of it
   * without error but for the rounding itself. */
  double unit = 1.0;
  std::uint64_t count = 0;
  std::array<Whole, 3> sum{};
  /** \brief xx xy xz yy yz zz */
  std::array<Whole, 6> products{};

  /** \brief Adds the place of the lattice nearest to this one [m]. */
  void
  add (const Eigen::Vector3d& place);

  ExactMoments&
  operator+= (const ExactMoments& other);

  /** \brief The same in meters, about the place of the lattice next to their centroid;
   * for no points, zero. */
  Moments
  toMoments () const;
};

/** \brief A lattice finer than a ten thousandth of a cell [m]. */
double
latticeFor (double cell);

} // namespace pcl_ops::apps

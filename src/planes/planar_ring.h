// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Silences a notice of Boost 1.74 about a deprecated header that Boost itself includes.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#undef BOOST_ALLOW_DEPRECATED_HEADERS

#include <pcl_ops/plane_extent.h>

#include <algorithm>
#include <cmath>

BOOST_GEOMETRY_REGISTER_POINT_2D (Eigen::Vector2d, double, cs::cartesian, x(), y())

namespace pcl_ops::internal {

/** \brief A polygon for Boost.Geometry, with its corners in the same order as in
 * outlines of PlaneExtent: counter-clockwise, the first corner not repeated. */
using Ring = boost::geometry::model::ring<Eigen::Vector2d, false, false>;

/** \brief Returns the points without those with a NaN or infinite coordinate. */
inline PlanarPoints
finiteOf (const PlanarPoints& points)
{
  PlanarPoints finite;
  for (const Eigen::Vector2d& point : points)
    if (point.allFinite())
      finite.push_back (point);
  return finite;
}

/** \brief Returns the factor that scales points for the predicates of Boost.Geometry: 1
 * if the largest absolute coordinate is 0 or from 1 to 10^6, else the power of two that
 * scales it to between 1 and 2. The predicates have an absolute tolerance, too large
 * for coordinates below 1. For larger coordinates than 10^6 they fail if these differ
 * by many orders of magnitude. */
inline double
unitScale (const PlanarPoints& points)
{
  double largest = 0.0;
  for (const Eigen::Vector2d& point : points)
    if (point.allFinite())
      largest = std::max (largest, point.lpNorm<Eigen::Infinity>());
  constexpr double max_unscaled = 1e6;
  const bool is_usual = largest == 0.0 || (largest >= 1.0 && largest <= max_unscaled);
  return is_usual ? 1.0 : std::ldexp (1.0, -std::ilogb (largest));
}

} // namespace pcl_ops::internal

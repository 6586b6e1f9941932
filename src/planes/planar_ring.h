// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Boost 1.74 remarks in every build on a header it includes itself.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#undef BOOST_ALLOW_DEPRECATED_HEADERS

#include <pcl_ops/plane_extent.h>

#include <algorithm>
#include <cmath>

BOOST_GEOMETRY_REGISTER_POINT_2D (Eigen::Vector2d, double, cs::cartesian, x(), y())

namespace pcl_ops::internal {

/** \brief A polygon as Boost.Geometry takes it, in the order our outlines have:
 * counter-clockwise, the first corner not repeated. */
using Ring = boost::geometry::model::ring<Eigen::Vector2d, false, false>;

inline PlanarPoints
finiteOf (const PlanarPoints& points)
{
  PlanarPoints finite;
  for (const Eigen::Vector2d& point : points)
    if (point.allFinite())
      finite.push_back (point);
  return finite;
}

/** \brief The power of two that takes coordinates to about 1 where they are below it,
 * as Boost's predicates have an absolute tolerance there, or beyond a thousand
 * kilometers, as these predicates fail for points over many decades; else 1. */
inline double
unitScale (const PlanarPoints& points)
{
  double largest = 0.0;
  for (const Eigen::Vector2d& point : points)
    if (point.allFinite())
      largest = std::max (largest, point.lpNorm<Eigen::Infinity>());
  constexpr double farthest = 1e6;
  const bool is_usual = largest == 0.0 || (largest >= 1.0 && largest <= farthest);
  return is_usual ? 1.0 : std::ldexp (1.0, -std::ilogb (largest));
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Boost 1.74 remarks in every build on a header it includes itself.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#undef BOOST_ALLOW_DEPRECATED_HEADERS

namespace pcl_ops::internal {

/** \brief A polygon as Boost.Geometry takes it, in the order our outlines have:
 * counter-clockwise, the first corner not repeated. */
using RingPoint = boost::geometry::model::d2::point_xy<double>;
using Ring = boost::geometry::model::ring<RingPoint, false, false>;

} // namespace pcl_ops::internal

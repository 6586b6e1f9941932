// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief The rings of the alpha shape: the border of the triangles of the Delaunay
 * triangulation whose circumscribed circle has a radius of at most alpha.
 * \param[in] points finite points, in any order
 * \param[in] alpha above 0, in the unit of the points
 * \return outer rings, counter-clockwise, and rings around holes, clockwise, in any
 * order; no ring passes a point twice */
std::vector<PlanarPoints>
alphaShapeRings (const PlanarPoints& points, double alpha);

} // namespace pcl_ops::internal

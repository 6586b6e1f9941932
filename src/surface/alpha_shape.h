// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief The rings around the triangles between neighboring points (Delaunay) that
 * have a circumscribed circle of radius alpha at most, those around holes among them;
 * in any order. None passes a point twice.
 * \param[in] points finite ones, in any order
 * \param[in] alpha above 0 [m] */
std::vector<PlanarPoints>
alphaShapeRings (const PlanarPoints& points, double alpha);

} // namespace pcl_ops::internal

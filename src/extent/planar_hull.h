// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

namespace pcl_ops::internal {

/** \brief The convex hull of all points.
 * \param[in] points finite ones
 * \return counter-clockwise, the first corner not repeated; empty where the points span
 * no area */
PlanarPoints
hullOfAll (const PlanarPoints& points);

} // namespace pcl_ops::internal

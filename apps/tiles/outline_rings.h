// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "outline_edges.h"
#include <pcl_ops/plane_extent.h>

namespace pcl_ops::apps {

/** \brief The parts of a plane, each with its holes, by falling area. The outermost
 * points are within the plane's edge by a third of their spacing in the mean; sides are
 * moved out by as much.
 * \param[in] edges of all tiles; of two that are opposite none is left
 * \param[in] frame in the plane, seen from where the edges go round to the left
 * \param[in] unit of the lattice [m]
 * \param[in] points on the plane, which give their spacing
 * \param[in] min_area of a part beside the largest, and of a hole [m^2] */
std::vector<PlanarRings>
outlineOf (std::vector<OutlineEdge> edges,
           const PlaneFrame& frame,
           double unit,
           double points,
           double min_area);

} // namespace pcl_ops::apps

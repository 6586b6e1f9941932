// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "outline_edges.h"
#include <pcl_ops/plane_extent.h>

#include <vector>

namespace pcl_ops::apps {

/** \brief Returns the parts of a plane, each with its holes, by falling area of their
 * outer rings. On average the outermost points lie inside the real boundary of the
 * plane by 0.3 of the spacing of the points. Corners are moved outwards by that
 * distance.
 * \param[in] edges of all tiles; opposite ones cancel
 * \param[in] frame of the plane, in which the plane is to the left of the edges
 * \param[in] unit of the coordinates of the edges (\ref outlineUnit) [m]
 * \param[in] points number of points on the plane, which gives their spacing
 * \param[in] min_area of a hole, and of a part other than the largest: smaller ones are
 * left out [m^2] */
std::vector<PlanarRings>
outlineOf (const std::vector<OutlineEdge>& edges,
           const PlaneFrame& frame,
           double unit,
           double points,
           double min_area);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_ops {

/** \brief Three corners of an outline, by their numbers. */
using Triangle = std::array<std::size_t, 3>;

/** \brief Cuts an outline into triangles between its corners, because most programs
 * show meshes of triangles only. The outline may have holes and need not be convex.
 *
 * Bridges from each hole to the nearest corner in sight make one ring of all rings.
 * Then the ears of that ring are cut off one after the other (Meisters, *Polygons have
 * ears*, American Mathematical Monthly 82, 1975; Eberly, *Triangulation by ear
 * clipping*, Geometric Tools, 2002).
 * \param[in] rings the outline counter-clockwise, then its holes clockwise; no ring
 * crosses or touches another one
 * \return counter-clockwise triangles of the corners of all rings, numbered ring after
 * ring; none if they would not cover the area of the rings */
PCL_OPS_EXPORT std::vector<Triangle>
triangulate (const PlanarRings& rings);

} // namespace pcl_ops

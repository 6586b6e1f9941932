// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_ops {

/** \brief Indices of three corners of an outline. */
using Triangle = std::array<std::size_t, 3>;

/** \brief Triangulates an outline between its corners, because most programs show only
 * meshes of triangles. The outline may have holes and need not be convex.
 *
 * A bridge from each hole to a visible corner joins all rings to one ring.
 * Then the ears of this ring are clipped one after the other (Meisters, *Polygons have
 * ears*, American Mathematical Monthly 82, 1975; Eberly, *Triangulation by ear
 * clipping*, Geometric Tools, 2002).
 * \param[in] rings the outline counter-clockwise, then its holes clockwise; no ring
 * crosses or touches another one
 * \return counter-clockwise triangles of the corners of all rings, which are numbered
 * ring after ring; empty if the triangles do not cover the area of the rings */
PCL_OPS_EXPORT std::vector<Triangle>
triangulate (const PlanarRings& rings);

} // namespace pcl_ops

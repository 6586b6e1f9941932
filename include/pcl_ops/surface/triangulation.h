// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_ops {

/** \brief Three corners of an outline, by their places in it. */
using Triangle = std::array<std::size_t, 3>;

/** \brief Cuts an outline, convex or not, with holes or without, into triangles between
 * its corners, as most programs show meshes of triangles only, by ears off a ring with
 * bridges: those to the nearest corners in sight make one ring of all, whose ears
 * are cut off (Meisters, *Polygons have ears*, American Mathematical Monthly 82, 1975;
 * Eberly, *Triangulation by ear clipping*, Geometric Tools, 2002).
 * \param[in] rings the outline counter-clockwise, then holes clockwise, none of which
 * crosses or touches another
 * \return counter-clockwise triangles of the corners of all rings, numbered ring after
 * ring; none where they would not cover the area of the rings */
PCL_OPS_EXPORT std::vector<Triangle>
triangulate (const PlanarRings& rings);

} // namespace pcl_ops

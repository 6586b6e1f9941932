// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

namespace pcl_ops {

/** \brief Returns the concave outline of points in a plane and its holes: the border of
 * all triangles of the Delaunay triangulation with a circumradius of at most alpha
 * (alpha shape of Edelsbrunner, Kirkpatrick & Seidel, On the shape of a set of points
 * in the plane, 1983).
 *
 * The radius grows until the largest ring has at least 99 % of the points inside; after
 * eight attempts the result is the convex hull. Holes are areas without points, wide
 * enough for a circle of this radius. Points well inside are thinned first.
 * \param[in] points in any order; points with a NaN or infinite coordinate are left out
 * \param[in] alpha the first radius [m]; 0, less or NaN: six times the mean distance
 * between neighboring points
 * \return the outer ring, then the holes by descending area; empty if the points span
 * no area */
PCL_OPS_EXPORT PlanarRings
concaveOutline (const PlanarPoints& points, double alpha = 0.0);

/** \brief The same as \ref planeExtent, but with the outline and the holes of \ref
 * concaveOutline instead of the convex hull.
 * \throw std::invalid_argument if an inlier is not an index into the cloud */
PCL_OPS_EXPORT PlaneExtent
concavePlaneExtent (const CloudView& cloud,
                    const PlaneSegment& plane,
                    double alpha = 0.0);

} // namespace pcl_ops

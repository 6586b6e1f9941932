// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

namespace pcl_ops {

/** \brief The concave outline of points in a plane and its holes: the border of the
 * triangles of the Delaunay triangulation that have a circumscribed circle of radius
 * alpha at most (alpha shape of Edelsbrunner, Kirkpatrick & Seidel, On the shape of a
 * set of points in the plane, 1983).
 *
 * The radius grows until the outline is a single one with at least 99 % of the points
 * inside; the convex hull is what it ends in. Holes are places without points wide
 * enough for a circle of that radius. Points clearly inside are thinned first.
 * \param[in] points in any order; those with a NaN or infinite coordinate are left out
 * \param[in] alpha the radius to begin with [m]; 0: six times the mean distance between
 * neighboring points
 * \return the outer ring, then the holes by falling area; empty where the points span
 * no area */
PCL_OPS_EXPORT PlanarRings
concaveOutline (const PlanarPoints& points, double alpha = 0.0);

/** \brief As \ref planeExtent, with the \ref concaveOutline as hull, and its holes. */
PCL_OPS_EXPORT PlaneExtent
concavePlaneExtent (const CloudView& cloud,
                    const PlaneSegment& plane,
                    double alpha = 0.0);

} // namespace pcl_ops

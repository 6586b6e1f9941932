// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drawing.h"
#include <pcl_ops/plane_edges.h>

namespace pcl_ops::apps {

/** \brief Returns a drawing in space with the edges as lines on a layer EDGE. Corners
 * are not drawn.
 * \param[in] meter length of a meter in the unit of the edges */
Drawing
drawingOf (const PlaneEdges& edges, double meter);

/** \brief Returns a GeoJSON map in space with edges as lines, then corners as points.
 * Both have the ids of their planes as properties "plane1", "plane2" (and "plane3"). An
 * edge has also "length" [unit of the edges] and "angle" [degree].
 * \param[in] edges in which PlaneEdge::planes and PlaneCorner::planes are ids, not
 * indices
 * \param[in] crs as of \ref featureCollection */
std::string
edgesToGeoJson (const PlaneEdges& edges, const std::string& crs);

} // namespace pcl_ops::apps

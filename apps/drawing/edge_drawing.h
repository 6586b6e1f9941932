// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drawing.h"
#include <pcl_ops/plane_edges.h>

namespace pcl_ops::apps {

/** \brief Returns a drawing of the edges in space on a layer EDGE, without corners.
 * \param[in] meter length of a meter in the unit of the edges */
Drawing
drawingOf (const PlaneEdges& edges, double meter);

/** \brief Returns a GeoJSON text: edges as lines, then corners as points, in space. An
 * edge has the properties "length" [unit of the edges] and "angle" [degree].
 * \param[in] edges with ids of planes in place of their indices
 * \param[in] crs "EPSG:N" or empty */
std::string
edgesToGeoJson (const PlaneEdges& edges, const std::string& crs);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/plane_extent.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Corners of a closed line, the first not repeated. */
using Ring = std::vector<Eigen::Vector3d>;

/** \brief The outline of a plane, then those of holes in it; none where it has no area.
 */
using Rings = std::vector<Ring>;

/** \brief The same with the outline counter-clockwise and holes clockwise as seen from
 * above, as maps want it. Vertical rings, which are lines from there, stay as they are.
 */
Rings
seenFromAbove (Rings rings);

/** \brief How many decimals coordinates are written with: three, or as many as a
 * thousandth of the narrowest plane takes. */
int
decimalsFor (const std::vector<PlaneExtent>& extents);

/** \brief As "POLYGON Z ((x y z, ...), ...)" of OGC 06-103r4, rings closed. */
std::string
toWkt (const Rings& rings, int decimals);

/** \brief As a geometry of GeoJSON (RFC 7946), rings closed; null for none. */
std::string
toGeoJsonGeometry (const Rings& rings, int decimals);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_ops::apps {

/** \brief Whether this build has SQLite. */
bool
hasSqlite ();

/** \brief Returns the bytes of a GeoPackage (OGC 12-128r18) with one layer. The layer
 * has the features of a GeoJSON map with their geometries and properties, and the EPSG
 * code of the reference system of the map. The same map always gives the same bytes.
 * \param[in] geo_json the text of the map, as of \ref featureCollection
 * \param[in] layer name of the layer
 * \throws std::logic_error in a build without SQLite */
std::string
geoPackageOf (const std::string& geo_json, const std::string& layer);

} // namespace pcl_ops::apps

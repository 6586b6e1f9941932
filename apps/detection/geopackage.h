// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_ops::apps {

/** \brief Whether SQLite was there when this was built. */
bool
hasSqlite ();

/** \brief The bytes of a GeoPackage (OGC 12-128r18) with one layer, which has the
 * features of a map in GeoJSON: geometry, properties, and the EPSG code of its
 * reference system. The same bytes for the same map. Without SQLite it throws a
 * std::logic_error.
 */
std::string
geoPackageOf (const std::string& geo_json, const std::string& layer);

} // namespace pcl_ops::apps

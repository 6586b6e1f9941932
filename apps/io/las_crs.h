// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_file.h"

#include <string>

namespace pcl_ops::apps {

/** \brief The system that the text of a reference system (OGC 01-009, "WKT") says it is
 * of x and y: "EPSG:N", or empty where it has no number. */
std::string
crsInWkt (const std::string& text);

/** \brief The reference system of x and y of a file, by its keys of GeoTIFF (OGC
 * 19-008) or its text: "EPSG:N", or empty where the file has none with a number. */
std::string
crsOf (LasFile& las);

/** \brief The length of a meter in the unit of x and y, by the reference system: 3.28
 * feet; 1 where that says nothing. */
double
unitsInMeter (LasFile& las);

} // namespace pcl_ops::apps

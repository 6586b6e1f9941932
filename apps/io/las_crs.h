// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_file.h"

#include <string>

namespace pcl_ops::apps {

/** \brief Returns the reference system of x and y in a WKT text (OGC 01-009): "EPSG:N",
 * or empty if the text has no such number. */
std::string
crsInWkt (const std::string& text);

/** \brief Returns the reference system of x and y of a file (\ref toldByCrs): "EPSG:N",
 * or empty if neither its WKT nor its GeoTIFF keys (OGC 19-008) have a number. */
std::string
crsOf (LasFile& las);

/** \brief Returns the length of a meter in the unit of x and y (\ref unitOf): 3.28 for
 * feet; 1 for meters, and also for degrees and unknown units. */
double
unitsInMeter (LasFile& las);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_file.h"

#include <string>

namespace pcl_ops::apps {

enum class LasUnit { Unknown, Meter, Foot, Degree };

/** \brief Returns the unit of x and y in a WKT text (OGC 01-009). */
LasUnit
unitInWkt (const std::string& text);

/** \brief Returns the unit of x and y of a file, by its WKT, else by its GeoTIFF keys
 * (OGC 19-008). A key that has only the EPSG number of a system tells no unit. */
LasUnit
unitOf (LasFile& las);

} // namespace pcl_ops::apps

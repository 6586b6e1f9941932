// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_file.h"

#include <string>

namespace pcl_ops::apps {

enum class LasUnit { Unknown, Meter, Foot, Degree };

/** \brief The unit of x and y in the text of a reference system (OGC 01-009, "WKT"). */
LasUnit
unitInWkt (const std::string& text);

/** \brief The unit of x and y by the reference system of a file: its text, or its keys
 * of GeoTIFF (OGC 19-008) if these name the unit, and not only the number of a system.
 */
LasUnit
unitOf (LasFile& las);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_file.h"

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief An entry of the directory of GeoTIFF keys (OGC 19-008), in its byte layout.
 */
struct GeoKey {
  LasHeader::UInt16 id;
  /** \brief 0 if the value is in \ref value; else the tag that has it. */
  LasHeader::UInt16 location;
  LasHeader::UInt16 count, value;
};

/** \brief Returns the entries of a directory of GeoTIFF keys.
 * \param[in] directory content of LasFile::geo_keys */
std::vector<GeoKey>
geoKeysIn (const std::string& directory);

enum class LasUnit { Unknown, Meter, Foot, Degree };

/** \brief Returns the offset of the vertical system in a WKT text (OGC 01-009, 18-010);
 * that of the end if there is none. */
std::size_t
beginOfHeights (const std::string& text);

/** \brief Returns the unit of x and y in a WKT text. */
LasUnit
unitInWkt (const std::string& text);

/** \brief Returns the unit of z in a WKT text. */
LasUnit
heightUnitInWkt (const std::string& text);

/** \brief Returns the unit of x and y of a file, by its WKT, else by its GeoTIFF keys
 * (OGC 19-008). Keys that have only the EPSG number of a system tell no other unit than
 * feet. */
LasUnit
unitOf (LasFile& las);

/** \brief Returns the unit of z of a file, by its WKT, else by its GeoTIFF keys. */
LasUnit
heightUnitOf (LasFile& las);

} // namespace pcl_ops::apps

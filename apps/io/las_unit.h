// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_file.h"

#include <optional>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief An entry of the directory of GeoTIFF keys (OGC 19-008), in its byte layout.
 */
struct GeoKey {
  /** \brief Which property of the reference system the key tells. */
  LasHeader::UInt16 id;
  /** \brief 0 if \ref value is the value of the key; else the number of the TIFF tag
   * that has the value. */
  LasHeader::UInt16 location;
  LasHeader::UInt16 count, value;
};

/** \brief Returns the entries of a directory of GeoTIFF keys.
 * \param[in] directory content of the record LasFile::geo_keys */
std::vector<GeoKey>
geoKeysIn (const std::string& directory);

/** \brief Returns what a file tells about its reference system. The bit of the header
 * for WKT says which of two records counts (LAS 1.4): WKT, or keys of GeoTIFF. Where
 * that one is missing or tells nothing, the other one is read.
 * \tparam Answer Answer() means nothing
 * \param[in] in_wkt, in_keys return what the text or the directory of keys tells */
template <typename Answer>
Answer
toldByCrs (LasFile& las,
           Answer (*in_wkt) (const std::string& text),
           Answer (*in_keys) (const std::string& directory))
{
  constexpr unsigned wkt_bit = 0x10;
  Answer by_wkt{};
  if (las.wkt)
    by_wkt = in_wkt (las.bytes (las.wkt->content, las.wkt->end));
  Answer by_keys{};
  if (las.geo_keys)
    by_keys = in_keys (las.bytes (las.geo_keys->content, las.geo_keys->end));
  const bool does_wkt_count = (las.header.global_encoding & wkt_bit) != 0;
  const Answer& preferred = does_wkt_count ? by_wkt : by_keys;
  const Answer& other = does_wkt_count ? by_keys : by_wkt;
  return preferred != Answer() ? preferred : other;
}

/** \brief The unit of coordinates by the reference system of a file. */
enum class LasUnit { Unknown, Meter, Foot, Degree };

/** \brief Returns the offset in a WKT text (OGC 01-009, 18-010) of the part on the
 * vertical reference system; the size of the text if there is none. */
std::size_t
verticalSystemBegin (const std::string& text);

/** \brief Returns the unit of x and y in a WKT text. */
LasUnit
unitInWkt (const std::string& text);

/** \brief Returns the unit of z in a WKT text. */
LasUnit
heightUnitInWkt (const std::string& text);

/** \brief Returns the unit of x and y of a file (\ref toldByCrs). Where the keys have
 * only the EPSG number of a system, the unit is Foot (\ref isInFeet), else Meter. */
LasUnit
unitOf (LasFile& las);

/** \brief Returns the unit of z of a file (\ref toldByCrs). */
LasUnit
heightUnitOf (LasFile& las);

} // namespace pcl_ops::apps

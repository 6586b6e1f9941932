// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_crs.h"

#include "las_unit.h"

#include <algorithm>
#include <regex>

namespace pcl_ops::apps {

namespace {

/** \brief Returns the value of the GeoTIFF key with the id \p wanted; 0 if there is no
 * such key, or its value is not in the directory.
 * \param[in] directory content of the VLR with GeoTIFF keys */
std::uint16_t
valueOfKey (const std::string& directory, std::uint16_t wanted)
{
  for (const GeoKey& key : geoKeysIn (directory))
    if (key.id == wanted && key.location == 0)
      return key.value;
  return 0;
}

/** \brief Returns the reference system as \ref crsOf does. */
std::string
crsInKeys (const std::string& directory)
{
  // The ids of the keys whose values are EPSG numbers of reference systems, and the
  // value of a system that has no number.
  constexpr std::uint16_t projected_id = 3072;
  constexpr std::uint16_t geographic_id = 2048;
  constexpr std::uint16_t user_defined = 32767;
  // A file with a projected system may name its geographic base, too.
  for (const std::uint16_t id : {projected_id, geographic_id}) {
    const std::uint16_t number = valueOfKey (directory, id);
    if (number == user_defined)
      return "";
    if (number != 0)
      return "EPSG:" + std::to_string (number);
  }
  return "";
}

} // namespace

std::string
crsInWkt (const std::string& text)
{
  // The EPSG number ends the text of a system; a vertical system may follow.
  static const std::regex epsg_at_end (
      R"re((AUTHORITY|ID)\s*\[\s*"EPSG"\s*,\s*"?([0-9]{1,7})"?\s*\]\s*\]\s*,?\s*$)re");
  std::string system = text.substr (0, beginOfHeights (text));
  while (!system.empty() && system.back() == '\0')
    system.pop_back();
  constexpr std::size_t max_searched =
      100; // letters; the number and what follows are shorter
  const std::string end =
      system.substr (system.size() - std::min (max_searched, system.size()));
  std::smatch found;
  return std::regex_search (end, found, epsg_at_end) ? "EPSG:" + found[2].str() : "";
}

std::string
crsOf (LasFile& las)
{
  std::string crs;
  if (las.geo_keys)
    crs = crsInKeys (las.bytes (las.geo_keys->content, las.geo_keys->end));
  if (crs.empty() && las.wkt)
    crs = crsInWkt (las.bytes (las.wkt->content, las.wkt->end));
  return crs;
}

double
unitsInMeter (LasFile& las)
{
  constexpr double foot = 0.3048; // [m], international; the US foot is 2 ppm longer
  return unitOf (las) == LasUnit::Foot ? 1.0 / foot : 1.0;
}

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_crs.h"

#include "las_unit.h"

#include <algorithm>
#include <regex>

namespace pcl_ops::apps {

namespace {

/** \brief Returns the value of the GeoTIFF key with an id; 0 if there is no such key,
 * or its value is not in the directory.
 * \param[in] directory of GeoTIFF keys, as for \ref geoKeysIn */
std::uint16_t
valueOfKey (const std::string& directory, std::uint16_t id)
{
  for (const GeoKey& key : geoKeysIn (directory))
    if (key.id == id && key.location == 0)
      return key.value;
  return 0;
}

/** \brief Returns the reference system of x and y by GeoTIFF keys: "EPSG:N", or empty
 * if no key has its number.
 * \param[in] directory of GeoTIFF keys, as for \ref geoKeysIn */
std::string
crsInKeys (const std::string& directory)
{
  // Ids of keys whose value is the EPSG number of a reference system.
  constexpr std::uint16_t projected_id = 3072, geographic_id = 2048;
  constexpr std::uint16_t user_defined = 32767; // the value for a system without number
  // The projected system goes first: a file that has one may also have the geographic
  // system it is based on.
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
  std::string system = text.substr (0, verticalSystemBegin (text));
  while (!system.empty() && system.back() == '\0')
    system.pop_back();
  // Only the last characters are searched. What the expression matches is shorter, and
  // on a long text std::regex of libstdc++, which recurses for each character, could
  // exhaust the stack.
  constexpr std::size_t max_searched = 100;
  const std::string end =
      system.substr (system.size() - std::min (max_searched, system.size()));
  std::smatch found;
  return std::regex_search (end, found, epsg_at_end) ? "EPSG:" + found[2].str() : "";
}

std::string
crsOf (LasFile& las)
{
  return toldByCrs (las, crsInWkt, crsInKeys);
}

double
unitsInMeter (LasFile& las)
{
  constexpr double foot = 0.3048; // [m], international; the US foot is 2 ppm longer
  return unitOf (las) == LasUnit::Foot ? 1.0 / foot : 1.0;
}

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_crs.h"

#include "las_unit.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <regex>

namespace pcl_ops::apps {

namespace {

/** \brief Returns the value of a GeoTIFF key that is stored in the directory itself; 0
 * if there is no such key. */
std::uint16_t
shortKey (const std::string& directory, std::uint16_t wanted)
{
  // An entry: the key, where its value is (0: in the entry), the number of values, the
  // value. The first entry has the version and the number of keys.
  using Entry = std::array<LasHeader::Short, 4>;
  for (std::size_t at = sizeof (Entry); at + sizeof (Entry) <= directory.size();
       at += sizeof (Entry)) {
    Entry entry;
    std::memcpy (&entry, &directory[at], sizeof (entry));
    if (entry[0] == wanted && entry[1] == 0)
      return entry[3];
  }
  return 0;
}

std::string
crsInKeys (const std::string& directory)
{
  constexpr std::uint16_t projected = 3072;
  constexpr std::uint16_t geographic = 2048;
  constexpr std::uint16_t user_defined = 32767;
  // A file with a projected system may name its geographic base, too.
  for (const std::uint16_t key : {projected, geographic}) {
    const std::uint16_t number = shortKey (directory, key);
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
  static const std::regex last (
      R"re((AUTHORITY|ID)\s*\[\s*"EPSG"\s*,\s*"?([0-9]{1,7})"?\s*\]\s*\]\s*,?\s*$)re");
  std::string system = text.substr (0, text.find ("VERT"));
  while (!system.empty() && system.back() == '\0')
    system.pop_back();
  constexpr std::size_t enough = 100;
  const std::string end =
      system.substr (system.size() - std::min (enough, system.size()));
  std::smatch found;
  return std::regex_search (end, found, last) ? "EPSG:" + found[2].str() : "";
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
  constexpr double foot = 0.3048; // [m]; the US survey foot is 2 ppm longer
  return unitOf (las) == LasUnit::Foot ? 1.0 / foot : 1.0;
}

} // namespace pcl_ops::apps

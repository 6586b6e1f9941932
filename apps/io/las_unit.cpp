// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_unit.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <cstring>

namespace pcl_ops::apps {

namespace {

/** \brief An entry of the GeoKeyDirectoryTag; the first one is its header, of the same
 * size. */
struct GeoKey {
  LasHeader::Short id, location, count, value;
};

LasUnit
unitInKeys (const std::string& bytes)
{
  constexpr std::uint16_t model_type = 1024;
  constexpr std::uint16_t geographic = 2;
  constexpr std::uint16_t linear_unit = 3076;
  constexpr std::uint16_t meter = 9001;
  constexpr std::uint16_t last_foot = 9003; // US foot; 9002: international one
  LasUnit unit = LasUnit::Unknown;
  for (std::size_t at = sizeof (GeoKey); at + sizeof (GeoKey) <= bytes.size();
       at += sizeof (GeoKey)) {
    GeoKey key;
    std::memcpy (&key, &bytes[at], sizeof (key));
    if (key.id == model_type && key.value == geographic)
      return LasUnit::Degree;
    if (key.id == linear_unit && key.value == meter)
      unit = LasUnit::Meter;
    if (key.id == linear_unit && key.value > meter && key.value <= last_foot)
      unit = LasUnit::Foot;
  }
  return unit;
}

} // namespace

LasUnit
unitInWkt (const std::string& text)
{
  std::string system = boost::algorithm::to_upper_copy (text);
  system = system.substr (0, system.find ("VERT"));
  // In a projected system the last unit is that of x and y; the angle unit of its base
  // comes before it.
  const std::string key = "UNIT[\"";
  const std::size_t begin = system.rfind (key);
  if (begin == std::string::npos)
    return LasUnit::Unknown;
  const std::size_t name = begin + key.size();
  const std::string unit = system.substr (name, system.find ('"', name) - name);
  const auto has = [&] (const char* word) {
    return unit.find (word) != std::string::npos;
  };
  if (has ("DEGREE"))
    return LasUnit::Degree;
  if (has ("FOOT") || has ("FEET") || has ("FTUS"))
    return LasUnit::Foot;
  return has ("MET") ? LasUnit::Meter : LasUnit::Unknown;
}

LasUnit
unitOf (LasFile& las)
{
  LasUnit unit = LasUnit::Unknown;
  if (las.wkt)
    unit = unitInWkt (las.bytes (las.wkt->content, las.wkt->end));
  if (unit == LasUnit::Unknown && las.geo_keys)
    unit = unitInKeys (las.bytes (las.geo_keys->content, las.geo_keys->end));
  return unit;
}

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_unit.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <cstring>

namespace pcl_ops::apps {

namespace {

/** \brief Returns the unit of x and y by a directory of GeoTIFF keys. */
LasUnit
unitInKeys (const std::string& directory)
{
  constexpr std::uint16_t model_type_id = 1024, geographic = 2;
  constexpr std::uint16_t linear_unit_id = 3076;
  constexpr std::uint16_t meter = 9001, international_foot = 9002, us_foot = 9003;
  LasUnit unit = LasUnit::Unknown;
  for (const GeoKey& key : geoKeysIn (directory)) {
    if (key.id == model_type_id && key.value == geographic)
      return LasUnit::Degree;
    if (key.id != linear_unit_id)
      continue;
    if (key.value == meter)
      unit = LasUnit::Meter;
    if (key.value == international_foot || key.value == us_foot)
      unit = LasUnit::Foot;
  }
  return unit;
}

} // namespace

std::vector<GeoKey>
geoKeysIn (const std::string& directory)
{
  // In front of the entries is a header of the same size.
  constexpr std::size_t size = sizeof (GeoKey);
  std::vector<GeoKey> keys;
  for (std::size_t begin = size; begin + size <= directory.size(); begin += size)
    std::memcpy (&keys.emplace_back(), &directory[begin], size);
  return keys;
}

LasUnit
unitInWkt (const std::string& text)
{
  std::string system = boost::algorithm::to_upper_copy (text);
  system = system.substr (0, system.find ("VERT"));
  // In a projected system the last unit is that of x and y; the angle unit of its base
  // comes before it.
  const std::string key = "UNIT[\"";
  const std::size_t key_begin = system.rfind (key);
  if (key_begin == std::string::npos)
    return LasUnit::Unknown;
  const std::size_t begin = key_begin + key.size();
  const std::string unit = system.substr (begin, system.find ('"', begin) - begin);
  const auto has = [&] (const char* part_of_name) {
    return unit.find (part_of_name) != std::string::npos;
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

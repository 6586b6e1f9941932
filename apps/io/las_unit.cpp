// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_unit.h"

#include <boost/algorithm/string/case_conv.hpp>

#include "foot_systems.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace pcl_ops::apps {

namespace {

/** \brief How a unit begins in a WKT text in upper case; its name follows. */
constexpr const char* unit_key = "UNIT[\"";

/** \brief Returns the unit of a number of the EPSG dataset, as GeoTIFF keys have it. */
LasUnit
unitCalled (std::uint16_t number)
{
  constexpr std::uint16_t meter = 9001, international_foot = 9002, us_foot = 9003;
  if (number == meter)
    return LasUnit::Meter;
  const bool is_foot = number == international_foot || number == us_foot;
  return is_foot ? LasUnit::Foot : LasUnit::Unknown;
}

/** \brief Returns the unit of x and y by a directory of GeoTIFF keys. */
LasUnit
unitInKeys (const std::string& directory)
{
  constexpr std::uint16_t model_type_id = 1024, geographic = 2;
  constexpr std::uint16_t projected_id = 3072, linear_unit_id = 3076;
  std::optional<LasUnit> unit;
  bool is_in_feet = false; // by the number of the system
  for (const GeoKey& key : geoKeysIn (directory)) {
    if (key.id == model_type_id && key.value == geographic)
      return LasUnit::Degree;
    if (key.id == linear_unit_id)
      unit = unitCalled (key.value);
    if (key.id == projected_id && key.location == 0)
      is_in_feet = isInFeet (key.value);
  }
  return unit.value_or (is_in_feet ? LasUnit::Foot : LasUnit::Unknown);
}

/** \brief Returns the unit of z by a directory of GeoTIFF keys. */
LasUnit
heightUnitInKeys (const std::string& directory)
{
  constexpr std::uint16_t vertical_unit_id = 4099;
  LasUnit unit = LasUnit::Unknown;
  for (const GeoKey& key : geoKeysIn (directory))
    if (key.id == vertical_unit_id)
      unit = unitCalled (key.value);
  return unit;
}

/** \brief Returns the offset of the first keyword of WKT that is one of \p keywords,
 * has a bracket behind it, and is in no quoted name; the size of the text if there is
 * none.
 * \param[in] text in upper case */
std::size_t
findKeyword (const std::string& text, const std::vector<std::string>& keywords)
{
  bool is_quoted = false;
  const auto begins_at = [&text] (const std::string& keyword, std::size_t i) {
    if (text.compare (i, keyword.size(), keyword) != 0)
      return false;
    const std::size_t next = text.find_first_not_of (" \t\r\n", i + keyword.size());
    return next != std::string::npos && text[next] == '[';
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    is_quoted = is_quoted != (text[i] == '"');
    if (!is_quoted &&
        std::any_of (keywords.begin(), keywords.end(), [&] (const auto& keyword) {
          return begins_at (keyword, i);
        }))
      return i;
  }
  return text.size();
}

/** \brief Returns the unit whose name follows at an offset of a WKT text.
 * \param[in] text in upper case
 * \param[in] key_begin offset of \ref unit_key, or npos: no unit */
LasUnit
unitAt (const std::string& text, std::size_t key_begin)
{
  if (key_begin == std::string::npos)
    return LasUnit::Unknown;
  const std::size_t begin = key_begin + std::strlen (unit_key);
  const std::string unit = text.substr (begin, text.find ('"', begin) - begin);
  const auto has = [&] (const char* part_of_name) {
    return unit.find (part_of_name) != std::string::npos;
  };
  if (has ("DEGREE"))
    return LasUnit::Degree;
  if (has ("FOOT") || has ("FEET") || has ("FTUS"))
    return LasUnit::Foot;
  return has ("MET") ? LasUnit::Meter : LasUnit::Unknown;
}

/** \brief Returns the first unit that is told: by the WKT of a file, else by its
 * GeoTIFF keys. */
LasUnit
firstUnitIn (LasFile& las,
             LasUnit (*in_wkt) (const std::string& text),
             LasUnit (*in_keys) (const std::string& directory))
{
  LasUnit unit = LasUnit::Unknown;
  if (las.wkt)
    unit = in_wkt (las.bytes (las.wkt->content, las.wkt->end));
  if (unit == LasUnit::Unknown && las.geo_keys)
    unit = in_keys (las.bytes (las.geo_keys->content, las.geo_keys->end));
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

std::size_t
beginOfHeights (const std::string& text)
{
  return findKeyword (boost::algorithm::to_upper_copy (text),
                      {"VERT_CS", "VERTCRS", "VERTICALCRS"});
}

LasUnit
unitInWkt (const std::string& text)
{
  std::string system =
      boost::algorithm::to_upper_copy (text.substr (0, beginOfHeights (text)));
  // The heights at which a system may be used (VERTICALEXTENT) have their own unit.
  system.resize (findKeyword (system, {"VERTICALEXTENT"}));
  // In a projected system the last unit is that of x and y; the angle unit of its base
  // comes before it.
  return unitAt (system, system.rfind (unit_key));
}

LasUnit
heightUnitInWkt (const std::string& text)
{
  const std::string upper = boost::algorithm::to_upper_copy (text);
  return unitAt (upper, upper.find (unit_key, beginOfHeights (text)));
}

LasUnit
unitOf (LasFile& las)
{
  return firstUnitIn (las, unitInWkt, unitInKeys);
}

LasUnit
heightUnitOf (LasFile& las)
{
  return firstUnitIn (las, heightUnitInWkt, heightUnitInKeys);
}

} // namespace pcl_ops::apps

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

/** \brief What is in front of the name of a unit in a WKT text in upper case; also the
 * end of LENGTHUNIT[" and ANGLEUNIT[". */
constexpr const char* unit_key = "UNIT[\"";

/** \brief Returns a unit of length.
 * \param[in] epsg number of the unit in the EPSG dataset, the value of a GeoTIFF key */
LasUnit
lengthUnit (std::uint16_t epsg)
{
  constexpr std::uint16_t meter = 9001, international_foot = 9002, us_foot = 9003;
  if (epsg == meter)
    return LasUnit::Meter;
  const bool is_foot = epsg == international_foot || epsg == us_foot;
  return is_foot ? LasUnit::Foot : LasUnit::Unknown;
}

/** \brief Returns the unit of x and y by a directory of GeoTIFF keys. */
LasUnit
unitInKeys (const std::string& directory)
{
  constexpr std::uint16_t model_type_id = 1024, geographic = 2; // id and value
  constexpr std::uint16_t projected_id = 3072, linear_unit_id = 3076;
  constexpr std::uint16_t undefined = 0, user_defined = 32767; // have no number
  LasUnit unit_of_system = LasUnit::Unknown;
  std::optional<LasUnit> unit;
  for (const GeoKey& key : geoKeysIn (directory)) {
    if (key.id == model_type_id && key.value == geographic)
      return LasUnit::Degree;
    if (key.id == linear_unit_id)
      unit = lengthUnit (key.value);
    // Systems in yards, chains or kilometers are too rare for a list of their own.
    if (key.id == projected_id && key.location == 0 && key.value != undefined &&
        key.value != user_defined)
      unit_of_system = isInFeet (key.value) ? LasUnit::Foot : LasUnit::Meter;
  }
  return unit.value_or (unit_of_system);
}

/** \brief Returns the unit of a vertical reference system, one of those that surveys of
 * countries with feet have.
 * \param[in] epsg number of the system in the EPSG dataset */
LasUnit
unitOfVerticalSystem (std::uint16_t epsg)
{
  switch (epsg) {
  case 5702: // NGVD29 height (ftUS)
  case 6360: // NAVD88 height (ftUS)
  case 8228: // NAVD88 height (ft)
    return LasUnit::Foot;
  case 3855: // EGM2008 height
  case 5703: // NAVD88 height
  case 5714: // MSL height
  case 5773: // EGM96 height
    return LasUnit::Meter;
  default:
    return LasUnit::Unknown;
  }
}

/** \brief Returns the unit of z by a directory of GeoTIFF keys. */
LasUnit
heightUnitInKeys (const std::string& directory)
{
  constexpr std::uint16_t vertical_system_id = 4096, vertical_unit_id = 4099;
  LasUnit unit_of_system = LasUnit::Unknown;
  std::optional<LasUnit> unit;
  for (const GeoKey& key : geoKeysIn (directory)) {
    if (key.id == vertical_unit_id)
      unit = lengthUnit (key.value);
    if (key.id == vertical_system_id && key.location == 0)
      unit_of_system = unitOfVerticalSystem (key.value);
  }
  return unit.value_or (unit_of_system);
}

/** \brief Returns the offset in a WKT text of the first of its keywords that is one of
 * \p keywords; the size of the text if there is none. A keyword is outside of quotes,
 * and a bracket follows.
 * \param[in] text in upper case */
std::size_t
findKeyword (const std::string& text, const std::vector<std::string>& keywords)
{
  bool is_quoted = false;
  const auto is_at = [&text] (std::size_t offset, const std::string& keyword) {
    if (text.compare (offset, keyword.size(), keyword) != 0)
      return false;
    const std::size_t next =
        text.find_first_not_of (" \t\r\n", offset + keyword.size());
    return next != std::string::npos && text[next] == '[';
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    is_quoted = is_quoted != (text[i] == '"');
    if (!is_quoted &&
        std::any_of (keywords.begin(), keywords.end(), [&] (const auto& keyword) {
          return is_at (i, keyword);
        }))
      return i;
  }
  return text.size();
}

/** \brief Returns the unit whose name is behind \ref unit_key in a WKT text.
 * \param[in] text in upper case
 * \param[in] key_begin offset of this key in the text; npos if there is none: then the
 * unit is Unknown */
LasUnit
unitAt (const std::string& text, std::size_t key_begin)
{
  if (key_begin == std::string::npos)
    return LasUnit::Unknown;
  const std::size_t begin = key_begin + std::strlen (unit_key);
  const std::string name = text.substr (begin, text.find ('"', begin) - begin);
  const auto name_has = [&] (const char* part) {
    return name.find (part) != std::string::npos;
  };
  if (name_has ("DEGREE"))
    return LasUnit::Degree;
  if (name_has ("FOOT") || name_has ("FEET") || name_has ("FTUS"))
    return LasUnit::Foot;
  return name_has ("MET") ? LasUnit::Meter : LasUnit::Unknown; // meter or metre
}

} // namespace

std::vector<GeoKey>
geoKeysIn (const std::string& directory)
{
  // In front of the entries is a header of the size of an entry.
  constexpr std::size_t size = sizeof (GeoKey);
  std::vector<GeoKey> keys;
  for (std::size_t begin = size; begin + size <= directory.size(); begin += size)
    std::memcpy (&keys.emplace_back(), &directory[begin], size);
  return keys;
}

std::size_t
verticalSystemBegin (const std::string& text)
{
  return findKeyword (boost::algorithm::to_upper_copy (text),
                      {"VERT_CS", "VERTCRS", "VERTICALCRS"});
}

LasUnit
unitInWkt (const std::string& text)
{
  std::string system =
      boost::algorithm::to_upper_copy (text.substr (0, verticalSystemBegin (text)));
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
  return unitAt (upper, upper.find (unit_key, verticalSystemBegin (text)));
}

LasUnit
unitOf (LasFile& las)
{
  return toldByCrs (las, unitInWkt, unitInKeys);
}

LasUnit
heightUnitOf (LasFile& las)
{
  return toldByCrs (las, heightUnitInWkt, heightUnitInKeys);
}

} // namespace pcl_ops::apps

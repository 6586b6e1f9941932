// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/algorithm/string/join.hpp>

#include <io/las_header.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

using pcl_ops::apps::bytesOf;
using pcl_ops::apps::LasHeader;

/** \brief Id of the variable length record that has the coordinate reference system as
 * WKT (well-known text). */
inline constexpr std::uint16_t wkt_id = 2112;
/** \brief Bit of the header that says that WKT counts, not keys of GeoTIFF. */
inline constexpr std::uint16_t wkt_bit = 0x10;
/** \brief Id of the record that has it as keys of GeoTIFF (\ref geoKeys). */
inline constexpr std::uint16_t geo_keys_id = 34735;

// Keys of GeoTIFF.
inline constexpr std::uint16_t model_type = 1024;
inline constexpr std::uint16_t geographic_system = 2048;
inline constexpr std::uint16_t projected_system = 3072;
inline constexpr std::uint16_t linear_unit = 3076; // of x and y
inline constexpr std::uint16_t vertical_system = 4096;
inline constexpr std::uint16_t vertical_unit = 4099;
// Values of model_type, of projected_system, and of keys of units.
inline constexpr std::uint16_t projected_model = 1, geographic_model = 2;
inline constexpr std::uint16_t california_in_us_feet = 2230, oregon_in_feet = 2992;
inline constexpr std::uint16_t unit_meter = 9001, unit_foot = 9002, unit_us_foot = 9003;

/** \brief User of the records about coordinate reference systems. */
inline constexpr const char* projection_user = "LASF_Projection";

// Types of fields of extra bytes that we do not write (LAS 1.4, table 24).
inline constexpr char las_uint16 = 3, las_double = 10, las_pair_of_uint16 = 13;

/** \brief The content of a small LAS file. */
struct LasRecipe {
  /** \brief Minor version of LAS, 0 to 4. */
  std::uint8_t minor_version = 4;
  /** \brief The point format, 0 to 10. */
  std::uint8_t format = 6;
  /** \brief Raw coordinates of the points, of which there must be one or more. */
  std::vector<std::array<std::int32_t, 3>> points = {{1, 2, 3}, {4, 5, 6}};
  /** \brief A coordinate is the raw one times the scale plus the offset. */
  double scale = 0.001;
  std::array<double, 3> offset = {500000, 5400000, 0};
  /** \brief Bytes of variable length records (\ref lasVlr): before the points, and
   * those with 64 bits for their length behind the points (LAS 1.4). */
  std::vector<std::string> vlrs = {}, evlrs = {};
  /** \brief Extra bytes of each point record, equally many for each; empty: none. */
  std::vector<std::string> extra = {};
  /** \brief Bytes between the variable length records and the points. */
  std::string gap = {};
  /** \brief Bits of the header; \ref wkt_bit is one of them. */
  std::uint16_t global_encoding = 0;
};

/** \brief Length of the header of a record that is not extended [byte]. */
constexpr std::size_t vlr_header_length = 2 + 16 + 2 + 2 + 32;

/** \brief The header that a LAS file begins with. */
inline LasHeader&
headerIn (std::string& las)
{
  return reinterpret_cast<LasHeader&> (las[0]);
}

/** \brief A variable length record, or an extended one if \p Length has 64 bits.
 * \param[in] user id of the user, up to 16 letters
 * \param[in] content at most 65535 bytes */
template <typename Length = LasHeader::UInt16>
std::string
lasVlr (std::string user, std::uint16_t id, const std::string& content)
{
  user.resize (16);
  const std::string reserved (2, '\0'), description (32, 'd');
  return reserved + user + bytesOf (LasHeader::UInt16 (id)) +
         bytesOf (Length (static_cast<std::uint16_t> (content.size()))) + description +
         content;
}

/** \brief A record with the GeoKeyDirectoryTag of GeoTIFF: a header of four numbers,
 * and then for each key its id, 0, 1 and its value.
 * \param[in] keys each key and its value */
inline std::string
geoKeys (const std::vector<std::array<std::uint16_t, 2>>& keys)
{
  std::string bytes;
  const auto add = [&] (std::initializer_list<std::uint16_t> entry) {
    for (const std::uint16_t number : entry)
      bytes += bytesOf (LasHeader::UInt16 (number));
  };
  add ({1, 1, 0, static_cast<std::uint16_t> (keys.size())});
  for (const auto& [key, value] : keys)
    add ({key, 0, 1, value});
  return lasVlr (projection_user, geo_keys_id, bytes);
}

constexpr std::size_t extra_bytes_field_length = 192; // [byte]

/** \brief The description of a field of extra bytes, as the record LASF_Spec 4 has it.
 * \param[in] type data type of LAS 1.4, such as las_uint16; 0: undocumented bytes
 * \param[in] options for type 0 the number of bytes */
inline std::string
extraBytesField (const std::string& name, char type, char options = 0)
{
  std::string bytes = std::string (2, '\0') + type + options + name;
  bytes.resize (extra_bytes_field_length);
  return bytes;
}

/** \brief The point record with index \p i. Each byte between the coordinates and the
 * extra bytes is its position in the record plus 16 i: the bytes of a record differ
 * from each other, and from those at the same position in the next records. */
inline std::string
lasRecord (const LasRecipe& recipe, std::size_t i)
{
  constexpr std::array<std::size_t, 11> lengths_of_formats = {
      20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  std::string record;
  for (const std::int32_t raw : recipe.points[i])
    record += bytesOf (boost::endian::little_int32_t (raw));
  while (record.size() < lengths_of_formats.at (recipe.format))
    record += static_cast<char> (record.size() + 16 * i);
  return record + (recipe.extra.empty() ? "" : recipe.extra[i]);
}

/** \brief The bytes of the LAS file that a recipe describes. */
inline std::string
lasBytes (const LasRecipe& recipe)
{
  const std::string vlrs = boost::algorithm::join (recipe.vlrs, "") + recipe.gap;
  std::string records;
  for (std::size_t i = 0; i < recipe.points.size(); ++i)
    records += lasRecord (recipe, i);
  const auto points = static_cast<std::uint32_t> (recipe.points.size());
  LasHeader header{};
  header.signature = {'L', 'A', 'S', 'F'};
  header.global_encoding = recipe.global_encoding;
  header.system_id.fill ('s');
  header.major_version = 1;
  header.minor_version = recipe.minor_version;
  constexpr std::array sizes_of_versions{227, 227, 227, 235, 375}; // 1.0 to 1.4
  header.header_size = sizes_of_versions.at (recipe.minor_version);
  header.points_offset = static_cast<std::uint32_t> (header.header_size + vlrs.size());
  header.vlr_count = static_cast<std::uint32_t> (recipe.vlrs.size());
  header.format_bits = recipe.format;
  header.record_length = static_cast<std::uint16_t> (records.size() / points);
  header.scale.fill (recipe.scale);
  std::copy (recipe.offset.begin(), recipe.offset.end(), header.offset.begin());
  if (recipe.minor_version < 4)
    header.legacy_point_count = points;
  else {
    header.point_count = points;
    header.evlr_offset = recipe.evlrs.empty() ? 0 : header.pointsEnd();
    header.evlr_count = static_cast<std::uint32_t> (recipe.evlrs.size());
  }
  return bytesOf (header).substr (0, header.header_size) + vlrs + records +
         boost::algorithm::join (recipe.evlrs, "");
}

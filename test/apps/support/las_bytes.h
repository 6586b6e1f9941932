// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/las_header.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/** \brief What a small LAS file is made of. */
struct LasRecipe {
  unsigned minor_version = 4;
  unsigned format = 6;
  /** \brief Raw coordinates of the points. */
  std::vector<std::array<std::int32_t, 3>> points = {{1, 2, 3}, {4, 5, 6}};
  double scale = 0.001;
  std::array<double, 3> offset = {500000, 5400000, 0};
  /** \brief Whole variable length records, and those behind the points. */
  std::vector<std::string> vlrs = {}, evlrs = {};
  /** \brief Extra bytes of each record; all have the same number. */
  std::vector<std::string> extra = {};
  /** \brief Bytes between the variable length records and the points. */
  std::string gap = {};
};

/** \brief Where the fields of a header are. */
namespace las_at {
inline constexpr std::size_t signature = 0, major = 24, minor = 25, header_size = 94,
                             points_offset = 96, vlr_count = 100, format = 104,
                             record_length = 105, legacy_points = 107, scale = 131,
                             offset = 155, waveform_offset = 227, evlr_offset = 235,
                             evlr_count = 243, points = 247;
} // namespace las_at

/** \brief Puts bytes in place of some. */
inline void
put (std::string& bytes, std::size_t place, const std::string& changed)
{
  bytes.replace (place, changed.size(), changed);
}

template <typename Unsigned>
Unsigned
lasNumber (const std::string& las, std::size_t place)
{
  return pcl_ops::apps::fromLittleEndian<Unsigned> (las.data() + place);
}

inline std::size_t
lasHeaderSize (unsigned minor_version)
{
  return minor_version == 2 ? 227 : minor_version == 3 ? 235 : 375;
}

inline std::size_t
lasFormatLength (unsigned format)
{
  constexpr std::array<std::size_t, 11> lengths = {
      20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  return lengths.at (format);
}

/** \brief A variable length record, or an extended one with \p Length of 64 bits. */
template <typename Length = std::uint16_t>
std::string
lasVlr (std::string user, std::uint16_t id, const std::string& content)
{
  using pcl_ops::apps::littleEndian;
  user.resize (16);
  return std::string (2, '\0') + user + littleEndian (id) +
         littleEndian (static_cast<Length> (content.size())) + std::string (32, 'd') +
         content;
}

/** \brief The description of a field of extra bytes. */
inline std::string
extraBytesField (const std::string& name, std::uint8_t type, std::uint8_t options = 0)
{
  std::string bytes (192, '\0');
  put (bytes, 2, pcl_ops::apps::littleEndian (type));
  put (bytes, 3, pcl_ops::apps::littleEndian (options));
  put (bytes, 4, name);
  return bytes;
}

/** \brief A record whose bytes, but for the coordinates, tell it and its places apart.
 */
inline std::string
lasRecord (const LasRecipe& recipe, std::size_t i)
{
  std::string record;
  for (const std::int32_t raw : recipe.points[i])
    record += pcl_ops::apps::littleEndian (static_cast<std::uint32_t> (raw));
  while (record.size() < lasFormatLength (recipe.format))
    record += static_cast<char> (record.size() + 16 * i);
  return record + (recipe.extra.empty() ? "" : recipe.extra[i]);
}

inline std::string
lasHeader (const LasRecipe& recipe, std::size_t points_offset, std::size_t points_end)
{
  const bool is_newest = recipe.minor_version >= 4;
  const auto points = static_cast<std::uint32_t> (recipe.points.size());
  std::string header (lasHeaderSize (recipe.minor_version), '\0');
  const auto set = [&] (std::size_t place, auto number) {
    put (header, place, pcl_ops::apps::littleEndian (number));
  };
  put (header, las_at::signature, "LASF");
  put (header, 26, "a system, and the software that wrote it");
  set (las_at::major, std::uint8_t (1));
  set (las_at::minor, std::uint8_t (recipe.minor_version));
  set (las_at::header_size, std::uint16_t (header.size()));
  set (las_at::points_offset, std::uint32_t (points_offset));
  set (las_at::vlr_count, std::uint32_t (recipe.vlrs.size()));
  set (las_at::format, std::uint8_t (recipe.format));
  set (las_at::record_length, std::uint16_t (lasRecord (recipe, 0).size()));
  set (las_at::legacy_points, is_newest ? 0 : points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    set (las_at::scale + 8 * axis, recipe.scale);
    set (las_at::offset + 8 * axis, recipe.offset.at (axis));
  }
  if (is_newest) {
    set (las_at::evlr_offset, std::uint64_t (recipe.evlrs.empty() ? 0 : points_end));
    set (las_at::evlr_count, std::uint32_t (recipe.evlrs.size()));
    set (las_at::points, std::uint64_t (points));
  }
  return header;
}

/** \brief The bytes of the file. */
inline std::string
lasBytes (const LasRecipe& recipe)
{
  std::string vlrs, records, evlrs;
  for (const std::string& vlr : recipe.vlrs)
    vlrs += vlr;
  for (std::size_t i = 0; i < recipe.points.size(); ++i)
    records += lasRecord (recipe, i);
  for (const std::string& evlr : recipe.evlrs)
    evlrs += evlr;
  vlrs += recipe.gap;
  const std::size_t points_offset = lasHeaderSize (recipe.minor_version) + vlrs.size();
  return lasHeader (recipe, points_offset, points_offset + records.size()) + vlrs +
         records + evlrs;
}

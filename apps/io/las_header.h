// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/endian/arithmetic.hpp>

#include "header_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace pcl_ops::apps {

/** \brief Returns the bytes of an object without padding, as a file has them. */
template <typename What>
std::string
bytesOf (const What& what)
{
  return {reinterpret_cast<const char*> (&what), sizeof (what)};
}

/** \brief The public header block of LAS 1.4, in its byte layout. Before version 1.3 it
 * ends in front of the waveform offset, in 1.3 in front of that of the extended
 * variable length records. */
struct LasHeader {
  using Short = boost::endian::little_uint16_t;
  using Long = boost::endian::little_uint32_t;
  using LongLong = boost::endian::little_uint64_t;
  using Vector = std::array<boost::endian::little_float64_t, 3>;

  std::array<char, 4> signature;
  Short source, encoding;
  std::array<char, 16> project;
  std::uint8_t major_version, minor_version;
  std::array<char, 32> system, software;
  Short day, year, size;
  Long points_offset, vlr_count;
  /** \brief Point data record format, 0 to 10, and two high bits that mark LAZ. */
  std::uint8_t format;
  Short record_length;
  Long legacy_points;
  std::array<Long, 5> legacy_points_by_return;
  Vector scale, offset;
  /** \brief Largest x, smallest x, largest y, smallest y, largest z, smallest z. */
  std::array<boost::endian::little_float64_t, 6> bounds;
  LongLong waveform_offset, evlr_offset;
  Long evlr_count;
  LongLong points;
  std::array<LongLong, 15> points_by_return;

  std::uint8_t
  pointFormat () const
  {
    return format & 0x3fU;
  }

  std::uint64_t
  pointCount () const
  {
    return std::max<std::uint64_t> (points, legacy_points);
  }

  std::uint64_t
  pointsEnd () const
  {
    return points_offset + pointCount() * record_length;
  }
};
static_assert (sizeof (LasHeader) == 375, "as in LAS 1.4");

/** \brief Reads and checks the header. Members that an older version does not have are
 * zero. Whether the file holds all of its points is not checked.
 * \throws WorkError if the header contradicts itself or the length of the file */
LasHeader
readLasHeader (HeaderReader& reader);

/** \brief The header of a variable length record (VLR), in its byte layout. Extended
 * records have a longer \p length. */
template <typename Length>
struct LasVlrHeader {
  LasHeader::Short reserved;
  std::array<char, 16> user;
  LasHeader::Short id;
  Length length;
  std::array<char, 32> description;
};
using LasShortVlrHeader = LasVlrHeader<LasHeader::Short>;

/** \brief A variable length record: the bytes in the file where it, its content and its
 * end are, and its ids. */
struct LasVlr {
  std::uint64_t begin, content, end;
  std::string user;
  std::uint16_t id;

  std::uint64_t
  size () const
  {
    return end - content;
  }
};

/** \brief A field among the extra bytes of a record. */
struct LasField {
  std::string name;
  /** \brief The number of the type in Extra Bytes VLRs; 0 for undocumented bytes. */
  std::uint8_t type = 0;
  const char* type_name = "";
  std::string text = {};
  /** \brief For type 0 the number of undocumented bytes; else option bits. */
  std::uint8_t options = 0;
  /** \brief Offset of the field in a record [bytes]. */
  std::uint64_t place = 0;
};

inline const LasField label_field = {"label", 5, "uint32", "0: on no plane"};
inline const LasField distance_field = {
    "distance", 9, "float", "to its plane; NaN: on none"};
inline const LasField plane_field = {"plane", 5, "uint32", "of the piece; 0: on none"};

/** \brief Returns the 192 bytes with which an Extra Bytes VLR describes a field. */
std::string
descriptionOf (const LasField& field);

/** \brief Returns an Extra Bytes VLR.
 * \param[in] content descriptions as from \ref descriptionOf, one after the other */
std::string
extraBytesVlr (const std::string& content, std::uint8_t minor_version);

} // namespace pcl_ops::apps

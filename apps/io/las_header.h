// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/endian/arithmetic.hpp>

#include "file_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace pcl_ops::apps {

/** \brief Returns the bytes of an object that is in the byte layout of a file. */
template <typename Object>
std::string
bytesOf (const Object& object)
{
  return {reinterpret_cast<const char*> (&object), sizeof (object)};
}

/** \brief The public header block of LAS 1.4, in its byte layout. Offsets are from the
 * beginning of the file, in bytes. Before version 1.3 the header ends in front of \ref
 * waveform_offset, in 1.3 in front of \ref evlr_offset. */
struct LasHeader {
  using UInt16 = boost::endian::little_uint16_t;
  using UInt32 = boost::endian::little_uint32_t;
  using UInt64 = boost::endian::little_uint64_t;
  using Vector = std::array<boost::endian::little_float64_t, 3>;

  std::array<char, 4> signature;
  UInt16 source_id, global_encoding;
  std::array<char, 16> project_id;
  std::uint8_t major_version, minor_version;
  std::array<char, 32> system_id, generating_software;
  UInt16 creation_day, creation_year;
  UInt16 header_size;
  UInt32 points_offset;
  /** \brief Number of variable length records (VLRs), which follow the header. */
  UInt32 vlr_count;
  /** \brief Point data record format, 0 to 10, in the lower six bits; the upper two
   * mark LAZ. */
  std::uint8_t format_bits;
  /** \brief Number of bytes of a point record. */
  UInt16 record_length;
  /** \brief The number of points; 0 in a LAS 1.4 that readers of LAS 1.3 cannot read,
   * which has only \ref point_count. */
  UInt32 legacy_point_count;
  std::array<UInt32, 5> legacy_point_counts_by_return;
  /** \brief For x, y and z: a coordinate is raw * scale + offset. */
  Vector scale, offset;
  /** \brief Largest and smallest x, largest and smallest y, largest and smallest z. */
  std::array<boost::endian::little_float64_t, 6> bounds;
  /** \brief Offset of the record with waveforms; 0 for none. */
  UInt64 waveform_offset;
  /** \brief Offset and number of the extended variable length records (EVLRs), which
   * follow the points. */
  UInt64 evlr_offset;
  UInt32 evlr_count;
  UInt64 point_count;
  std::array<UInt64, 15> point_counts_by_return;

  std::uint8_t
  pointFormat () const
  {
    return format_bits & 0x3fU;
  }

  /** \brief Returns the number of points. \ref readLasHeader has checked that \ref
   * point_count and \ref legacy_point_count are equal, or one of them is 0. */
  std::uint64_t
  pointCount () const
  {
    return std::max<std::uint64_t> (point_count, legacy_point_count);
  }

  /** \brief Returns the offset of the end of the points, if they are not compressed. */
  std::uint64_t
  pointsEnd () const
  {
    return points_offset + pointCount() * record_length;
  }
};
static_assert (sizeof (LasHeader) == 375, "as in LAS 1.4");

/** \brief Number of bytes of the header in versions 1.0 to 1.2. */
constexpr std::uint16_t las_1_2_header_size = 227;

/** \brief Reads and checks the header. Members that an older version does not have are
 * zero. Whether the file holds all of its points is not checked.
 * \param[in] reader at the beginning of the file
 * \throws WorkError if the file is no LAS 1.0 to 1.4, or its header contradicts itself
 * or the length of the file */
LasHeader
readLasHeader (FileReader& reader);

/** \brief The header of a variable length record, in its byte layout.
 * \tparam Length type of \p content_length: 16 bits for a VLR, 64 for an EVLR */
template <typename Length>
struct LasVlrHeader {
  LasHeader::UInt16 reserved;
  std::array<char, 16> user_id;
  LasHeader::UInt16 record_id;
  Length content_length;
  std::array<char, 32> description;
};
using LasStandardVlrHeader = LasVlrHeader<LasHeader::UInt16>;

/** \brief Where a variable length record is in the file, and the two ids that tell what
 * it has. */
struct LasVlr {
  /** \brief Offsets in the file [bytes]: of the record, of its content, which follows
   * its header, and of the end of the record. */
  std::uint64_t begin, content, end;
  std::string user_id;
  std::uint16_t record_id;

  std::uint64_t
  contentSize () const
  {
    return end - content;
  }
};

/** \brief Numbers of the types of fields in Extra Bytes VLRs (LAS 1.4, table 24). */
constexpr std::uint8_t las_undocumented = 0, las_uint32 = 5, las_float = 9;

/** \brief A field among the extra bytes of a point record. */
struct LasField {
  std::string name;
  std::uint8_t type = las_undocumented;
  /** \brief Name of the type in messages. */
  const char* type_name = "";
  std::string description = {};
  /** \brief For \ref las_undocumented the number of bytes; for other types option bits.
   */
  std::uint8_t options = 0;
  /** \brief Offset of the field in a record [bytes]. */
  std::uint64_t offset = 0;
};

inline const LasField label_field = {"label", las_uint32, "uint32", "0: on no plane"};
inline const LasField distance_field = {
    "distance", las_float, "float", "to its plane; NaN: on none"};
inline const LasField plane_field = {
    "plane", las_uint32, "uint32", "of the piece; 0: on none"};

/** \brief Returns the 192 bytes with which an Extra Bytes VLR describes a field. */
std::string
descriptionOf (const LasField& field);

/** \brief Returns the bytes of an Extra Bytes VLR.
 * \param[in] descriptions as from \ref descriptionOf, one after the other
 * \param[in] minor_version of the LAS file */
std::string
extraBytesVlr (const std::string& descriptions, std::uint8_t minor_version);

} // namespace pcl_ops::apps

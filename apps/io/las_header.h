// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/endian/conversion.hpp>

#include <Eigen/Core>

#include "header_reader.h"

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

namespace pcl_ops::apps {

/** \brief A number from its bytes, the lowest first, on any host. */
template <typename Number>
Number
fromLittleEndian (const char* bytes)
{
  using namespace boost::endian;
  return endian_load<Number, sizeof (Number), order::little> (
      reinterpret_cast<const unsigned char*> (bytes));
}

template <typename Number>
std::string
littleEndian (Number number)
{
  using namespace boost::endian;
  std::string bytes (sizeof (number), '\0');
  endian_store<Number, sizeof (Number), order::little> (
      reinterpret_cast<unsigned char*> (bytes.data()), number);
  return bytes;
}

template <typename Number>
void
setNumber (std::string& bytes, std::size_t place, Number number)
{
  bytes.replace (place, sizeof (number), littleEndian (number));
}

/** \brief Where the fields of the public header block begin. */
namespace las_field {
inline constexpr std::size_t major_version = 24, minor_version = 25, header_size = 94,
                             points_offset = 96, vlr_count = 100, format = 104,
                             record_length = 105, legacy_points = 107, scale = 131,
                             offset = 155, bounds = 179, waveform_offset = 227,
                             evlr_offset = 235, evlr_count = 243, points = 247;
} // namespace las_field

/** \brief The public header block of a LAS, as far as its points need it. */
struct LasHeader {
  /** \brief 1.2, 1.3 or 1.4. */
  std::uint8_t major_version = 0, minor_version = 0;
  std::uint16_t size = 0;
  std::uint32_t points_offset = 0;
  std::uint32_t vlr_count = 0;
  /** \brief Point data record format, 0 to 10, without the bits that say LAZ. */
  std::uint8_t format = 0;
  bool says_laz = false;
  std::uint16_t record_length = 0;
  /** \brief The larger of both numbers. */
  std::uint64_t points = 0;
  std::uint32_t legacy_points = 0;
  Eigen::Vector3d scale, offset;
  /** \brief Zero in versions that have none. */
  std::uint64_t waveform_offset = 0, evlr_offset = 0;
  std::uint32_t evlr_count = 0;

  std::uint64_t
  pointsEnd () const
  {
    return points_offset + points * record_length;
  }
};

/** \brief Without a look at whether the file holds its points.
 * \throws WorkError if it makes no sense */
LasHeader
readLasHeader (HeaderReader& reader);

/** \brief Where a variable length record begins, its content, and its end. */
struct LasVlr {
  std::uint64_t begin = 0, content = 0, end = 0;
  std::string user;
  std::uint16_t id = 0;

  std::uint64_t
  size () const
  {
    return end - content;
  }
};

/** \brief A field of four bytes among the extra bytes of a record. */
struct LasField {
  std::string name;
  /** \brief As Extra Bytes VLRs number it. */
  std::uint8_t type;
  const char* type_name;
  std::string text;
  /** \brief Of undocumented bytes, their number. */
  std::uint8_t options = 0;
};

inline const LasField label_field = {"label", 5, "uint32", "0: on no plane"};
inline const LasField distance_field = {
    "distance", 9, "float", "to its plane; NaN: on none"};

/** \brief A LAS file but for its points, which may be compressed. */
struct LasFrame {
  /** \throws WorkError if the header makes no sense, a variable length record does not
   * fit in front of the points, or they describe more extra bytes than there are */
  explicit LasFrame (const std::string& file);

  /** \throws WorkError if the file has no points, or more than PCL's indices can tell
   * apart */
  void
  checkCount () const;

  /** \throws WorkError if an extended variable length record is not behind the points,
   * or reaches beyond the end of the file */
  void
  checkEvlrs ();

  std::string
  bytes (std::uint64_t begin, std::uint64_t end);

  /** \brief Lets the front of a copy say where its points and all behind them are.
   * \param[in] points_end in the file
   * \param[in] points_growth how many bytes more they have in the copy */
  void
  relocate (std::uint64_t points_end,
            std::int64_t points_growth,
            std::string& front) const;

  void
  copyRest (std::uint64_t begin, std::ostream& stream);

  /** \brief Where a field of that name and type is in a record. */
  std::optional<std::uint64_t>
  placeOf (const LasField& field) const;

  /** \brief Of whatever type. */
  bool
  hasNamed (const LasField& field) const;

  /** \brief What the content of \ref extra_bytes goes on with where fields are added to
   * a record: bytes not described yet come before them. */
  std::string
  descriptionsOf (const std::vector<LasField>& added) const;

  std::string file;
  HeaderReader reader;
  LasHeader header;
  std::uint64_t vlrs_end = 0;
  /** \brief What describes the extra bytes of a record, and compressed points. */
  std::optional<LasVlr> extra_bytes, laszip;
  /** \brief Where they end in a record. */
  std::uint64_t described_end = 0;

private:
  struct DescribedField {
    std::string name;
    std::uint8_t type;
    std::uint64_t place;
  };

  void
  readDescriptions ();

  std::vector<DescribedField> fields_;
};

/** \brief How an Extra Bytes VLR says what a field is. */
std::string
descriptionOf (const LasField& field);

std::string
extraBytesVlr (const std::string& content);

/** \brief Where it has the two-byte length of its content. */
inline constexpr std::uint64_t vlr_length_field = 20;

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_header.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief A variable length record: where it begins, its content, and its end. */
struct LasVlr {
  std::uint64_t begin = 0, content = 0, end = 0;
  std::string user;
  std::uint16_t id = 0;
};

/** \brief A field of four bytes among the extra bytes of a record. */
struct LasField {
  std::string name;
  /** \brief As Extra Bytes VLRs number it. */
  std::uint8_t type;
  const char* type_name;
  std::string text;
};

inline const LasField label_field = {"label", 5, "uint32", "0: on no plane"};
inline const LasField distance_field = {
    "distance", 9, "float", "to its plane; NaN: on none"};

/** \brief A field that a file has. */
struct LasDescribedField {
  std::string name;
  std::uint8_t type;
  /** \brief Where it is in a record. */
  std::uint64_t place;
};

/** \brief What the variable length records say about the extra bytes of a record. */
struct LasExtraBytes {
  /** \brief Where the last variable length record ends. */
  std::uint64_t vlrs_end = 0;
  /** \brief The one that describes extra bytes, if any does. */
  std::optional<LasVlr> vlr;
  /** \brief Where the extra bytes end that it describes, in a record. */
  std::uint64_t described_end = 0;
  std::vector<LasDescribedField> fields;
  /** \brief What LASzip needs to decompress the points, if they are compressed. */
  std::optional<LasVlr> laszip;

  /** \brief Where a field of that name and type is in a record, if there is one. */
  std::optional<std::uint64_t>
  placeOf (const LasField& field) const;

  /** \brief Whether there is a field of that name, of whatever type. */
  bool
  hasNamed (const LasField& field) const;
};

/** \brief Walks through the variable length records in front of the points.
 * \throws WorkError if one does not fit in there, or if they describe more extra bytes
 * than there are */
LasExtraBytes
readLasVlrs (HeaderReader& reader, const LasHeader& header);

/** \brief Walks through the extended variable length records, which are behind the
 * points.
 * \throws WorkError if one is not, or reaches beyond the end of the file */
void
checkLasEvlrs (HeaderReader& reader, const LasHeader& header);

/** \brief The descriptions of fields behind all bytes of a record, for the end of the
 * content of \ref LasExtraBytes::vlr: bytes not described yet come before them. */
std::string
descriptionsOf (const std::vector<LasField>& added,
                const LasHeader& header,
                const LasExtraBytes& extra);

std::string
extraBytesVlr (const std::string& content);

/** \brief Where the two-byte length of the content is in the header of one. */
inline constexpr std::uint64_t vlr_length_field = 20;

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_header.h"

#include <cstdint>
#include <optional>
#include <string>

namespace pcl_ops::apps {

/** \brief A variable length record: where it begins, its content, and its end. */
struct LasVlr {
  std::uint64_t begin = 0, content = 0, end = 0;
};

/** \brief What the variable length records say about the extra bytes of a record. */
struct LasExtraBytes {
  /** \brief Where the last variable length record ends. */
  std::uint64_t vlrs_end = 0;
  /** \brief The one that describes extra bytes, if any does. */
  std::optional<LasVlr> vlr;
  /** \brief Where the extra bytes end that it describes, in a record. */
  std::uint64_t described_end = 0;
  /** \brief Where the label is in a record, if there is one. */
  std::optional<std::uint64_t> label;
  /** \brief Whether there is a field with the label's name that is no uint32. */
  bool has_other_label = false;
  /** \brief What LASzip needs to decompress the points, if they are compressed. */
  std::optional<LasVlr> laszip;
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

/** \brief The description of a label behind all bytes of a record, for the end of the
 * content of \ref LasExtraBytes::vlr: bytes not described yet come before it. */
std::string
labelDescription (const LasHeader& header, const LasExtraBytes& extra);

/** \brief A whole variable length record with that content. */
std::string
extraBytesVlr (const std::string& content);

/** \brief Where the two-byte length of the content is in the header of one. */
inline constexpr std::uint64_t vlr_length_field = 20;

} // namespace pcl_ops::apps

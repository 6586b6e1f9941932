// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "header_reader.h"

#include <cstdint>
#include <string>

namespace pcl_ops::apps {

/** \brief Where the fields of a public header block begin that change as records grow.
 */
namespace las_field {
inline constexpr std::uint64_t points_offset = 96, vlr_count = 100, format = 104,
                               record_length = 105, waveform_offset = 227,
                               evlr_offset = 235;
} // namespace las_field

/** \brief The public header block of a LAS file, as far as its points need it. */
struct LasHeader {
  /** \brief Of version 1.2, 1.3 or 1.4. */
  std::uint8_t minor_version = 0;
  std::uint16_t size = 0;
  std::uint32_t points_offset = 0;
  std::uint32_t vlr_count = 0;
  /** \brief Point data record format, 0 to 10, without the bits that say LAZ. */
  std::uint8_t format = 0;
  bool says_laz = false;
  std::uint16_t record_length = 0;
  /** \brief Bytes of a record that its point format has a meaning for. */
  std::uint16_t format_length = 0;
  std::uint64_t points = 0;
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

/** \brief Reads the public header block, without the variable length records and
 * without a look at whether the file holds its points.
 * \throws WorkError if it makes no sense */
LasHeader
readLasHeader (HeaderReader& reader);

/** \brief \throws WorkError if the file has no points, or more than PCL's indices can
 * tell apart */
void
checkLasCount (const HeaderReader& reader,
               const LasHeader& header,
               const std::string& file);

/** \brief The same of points that are not compressed.
 * \throws WorkError also if the file does not hold them */
void
checkLasPoints (const HeaderReader& reader,
                const LasHeader& header,
                const std::string& file);

} // namespace pcl_ops::apps

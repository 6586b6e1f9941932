// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "header_reader.h"

#include <cstdint>
#include <iosfwd>
#include <string>

namespace pcl_ops::apps {

/** \brief Where fields of a public header block begin. */
namespace las_field {
inline constexpr std::size_t major_version = 24, minor_version = 25, header_size = 94,
                             points_offset = 96, vlr_count = 100, format = 104,
                             record_length = 105, legacy_points = 107, scale = 131,
                             offset = 155, bounds = 179, waveform_offset = 227,
                             evlr_offset = 235, evlr_count = 243, points = 247;
} // namespace las_field

/** \brief The public header block of a LAS file, as far as its points need it. */
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
  /** \brief Bytes of a record that its point format has a meaning for. */
  std::uint16_t format_length = 0;
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

/** \brief All that is in front of the points, for a copy to change. */
std::string
readLasFront (HeaderReader& reader, const LasHeader& header);

/** \brief Lets the front of a copy say where its points begin and where all is that is
 * behind them.
 * \param[in] points_end where the points end in the file
 * \param[in] points_growth how many bytes more the points have in the copy */
void
relocateLas (const HeaderReader& reader,
             const LasHeader& header,
             std::uint64_t points_end,
             std::int64_t points_growth,
             std::string& front);

/** \brief Copies the file from \p begin to its end. */
void
copyRest (HeaderReader& reader, std::uint64_t begin, std::ostream& stream);

} // namespace pcl_ops::apps

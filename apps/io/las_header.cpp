// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_header.h"

#include <pcl/types.h>

#include "little_endian.h"
#include <cli/errors.h>

#include <algorithm>
#include <array>
#include <limits>

namespace pcl_ops::apps {

namespace {

constexpr std::uint8_t oldest_minor = 2, newest_minor = 4;
/** \brief Of the versions 1.2, 1.3 and 1.4. */
constexpr std::array<std::uint16_t, 3> header_lengths = {227, 235, 375};
/** \brief Of the point data record formats 0 to 10. */
constexpr std::array<std::uint16_t, 11> format_lengths = {
    20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

using LasHeaderBytes = std::array<char, header_lengths.back()>;

/** \brief Zero behind the end of the file. */
LasHeaderBytes
headerBytesOf (HeaderReader& reader)
{
  LasHeaderBytes bytes{};
  reader.read (bytes.data(), std::min<std::size_t> (bytes.size(), reader.fileSize()));
  const std::string signature = "LASF";
  if (std::string (bytes.data(), signature.size()) != signature)
    reader.fail ("its first bytes are not LASF");
  if (reader.fileSize() < header_lengths.front())
    reader.fail ("it ends within its header");
  return bytes;
}

void
readVersion (const HeaderReader& reader, const LasHeaderBytes& bytes, LasHeader& header)
{
  const auto major = fromLittleEndian<std::uint8_t> (&bytes[24]);
  header.minor_version = fromLittleEndian<std::uint8_t> (&bytes[25]);
  if (major != 1 || header.minor_version < oldest_minor ||
      header.minor_version > newest_minor)
    reader.fail ("its version " + std::to_string (major) + "." +
                 std::to_string (header.minor_version) + " is not 1.2, 1.3 or 1.4");
  header.size = fromLittleEndian<std::uint16_t> (&bytes[94]);
  if (header.size < header_lengths.at (header.minor_version - oldest_minor))
    reader.fail ("its header size " + std::to_string (header.size) +
                 " is too small for its version");
  header.points_offset =
      fromLittleEndian<std::uint32_t> (&bytes[las_field::points_offset]);
  header.vlr_count = fromLittleEndian<std::uint32_t> (&bytes[las_field::vlr_count]);
  if (header.points_offset < header.size || header.points_offset > reader.fileSize())
    reader.fail ("its offset to point data " + std::to_string (header.points_offset) +
                 " is within its header or behind its end");
}

void
readRecordFormat (const HeaderReader& reader,
                  const LasHeaderBytes& bytes,
                  LasHeader& header)
{
  constexpr unsigned compressed = 0xc0;
  const auto format = fromLittleEndian<std::uint8_t> (&bytes[las_field::format]);
  header.says_laz = (format & compressed) != 0;
  header.format = static_cast<std::uint8_t> (format & ~compressed);
  if (header.format >= format_lengths.size())
    reader.fail ("its point data record format " + std::to_string (header.format) +
                 " is not 0 to 10");
  header.format_length = format_lengths.at (header.format);
  header.record_length =
      fromLittleEndian<std::uint16_t> (&bytes[las_field::record_length]);
  if (header.record_length < header.format_length)
    reader.fail ("its point data record length " +
                 std::to_string (header.record_length) +
                 " is too small for the format " + std::to_string (header.format));
}

void
readTransform (const HeaderReader& reader,
               const LasHeaderBytes& bytes,
               LasHeader& header)
{
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto place = 131 + 8 * static_cast<std::size_t> (axis);
    header.scale[axis] = doubleFromLittleEndian (&bytes[place]);
    header.offset[axis] = doubleFromLittleEndian (&bytes[place + 24]);
  }
  if (!header.scale.allFinite() || (header.scale.array() == 0.0).any())
    reader.fail ("a scale factor of its coordinates is zero or no number");
  if (!header.offset.allFinite())
    reader.fail ("an offset of its coordinates is no number");
}

void
readCounts (const HeaderReader& reader, const LasHeaderBytes& bytes, LasHeader& header)
{
  const auto legacy_points = fromLittleEndian<std::uint32_t> (&bytes[107]);
  header.points = legacy_points;
  if (header.minor_version >= 3)
    header.waveform_offset =
        fromLittleEndian<std::uint64_t> (&bytes[las_field::waveform_offset]);
  if (header.minor_version < 4)
    return;
  header.evlr_offset = fromLittleEndian<std::uint64_t> (&bytes[las_field::evlr_offset]);
  header.evlr_count = fromLittleEndian<std::uint32_t> (&bytes[243]);
  const auto points = fromLittleEndian<std::uint64_t> (&bytes[247]);
  if (points != 0 && legacy_points != 0 && points != legacy_points)
    reader.fail ("its numbers of points " + std::to_string (points) + " and " +
                 std::to_string (legacy_points) + " (legacy) differ");
  header.points = std::max (points, header.points);
}

} // namespace

LasHeader
readLasHeader (HeaderReader& reader)
{
  const LasHeaderBytes bytes = headerBytesOf (reader);
  LasHeader header;
  readVersion (reader, bytes, header);
  readRecordFormat (reader, bytes, header);
  readTransform (reader, bytes, header);
  readCounts (reader, bytes, header);
  return header;
}

void
checkLasCount (const HeaderReader& reader,
               const LasHeader& header,
               const std::string& file)
{
  constexpr auto most = std::numeric_limits<pcl::index_t>::max();
  if (header.points == 0)
    reader.failEmpty();
  if (header.points > static_cast<std::uint64_t> (most))
    throw WorkError (file,
                     "has " + std::to_string (header.points) + " points, more than " +
                         std::to_string (most) + "; split it into tiles");
}

void
checkLasPoints (const HeaderReader& reader,
                const LasHeader& header,
                const std::string& file)
{
  if (header.points > (reader.fileSize() - header.points_offset) / header.record_length)
    reader.failTruncated();
  checkLasCount (reader, header, file);
}

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_header.h"

#include <pcl/types.h>

#include "little_endian.h"
#include <cli/errors.h>

#include <algorithm>
#include <array>
#include <limits>
#include <ostream>
#include <vector>

namespace pcl_ops::apps {

namespace {

constexpr std::uint8_t oldest_minor = 2, newest_minor = 4;
/** \brief Of the versions 1.2, 1.3 and 1.4. */
constexpr std::array<std::uint16_t, 3> header_lengths = {227, 235, 375};
/** \brief Of the point data record formats 0 to 10. */
constexpr std::array<std::uint16_t, 11> format_lengths = {
    20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

/** \brief The bytes of a header, zero behind the end of the file. */
struct HeaderBytes {
  std::array<char, header_lengths.back()> bytes{};

  template <typename Number>
  void
  get (std::size_t place, Number& number) const
  {
    number = fromLittleEndian<Number> (&bytes[place]);
  }
};

HeaderBytes
headerBytesOf (HeaderReader& reader)
{
  HeaderBytes header;
  auto& bytes = header.bytes;
  reader.read (bytes.data(), std::min<std::size_t> (bytes.size(), reader.fileSize()));
  if (std::string (bytes.data(), 4) != "LASF")
    reader.fail ("its first bytes are not LASF");
  if (reader.fileSize() < header_lengths.front())
    reader.fail ("it ends within its header");
  return header;
}

void
readVersion (const HeaderReader& reader, const HeaderBytes& bytes, LasHeader& header)
{
  std::uint8_t major = 0;
  bytes.get (24, major);
  bytes.get (25, header.minor_version);
  if (major != 1 || header.minor_version < oldest_minor ||
      header.minor_version > newest_minor)
    reader.fail ("its version " + std::to_string (major) + "." +
                 std::to_string (header.minor_version) + " is not 1.2, 1.3 or 1.4");
  bytes.get (las_field::header_size, header.size);
  if (header.size < header_lengths.at (header.minor_version - oldest_minor))
    reader.fail ("its header size " + std::to_string (header.size) +
                 " is too small for its version");
  bytes.get (las_field::points_offset, header.points_offset);
  bytes.get (las_field::vlr_count, header.vlr_count);
  if (header.points_offset < header.size || header.points_offset > reader.fileSize())
    reader.fail ("its offset to point data " + std::to_string (header.points_offset) +
                 " is within its header or behind its end");
}

void
readRecordFormat (const HeaderReader& reader,
                  const HeaderBytes& bytes,
                  LasHeader& header)
{
  constexpr unsigned compressed = 0xc0;
  bytes.get (las_field::format, header.format);
  header.says_laz = (header.format & compressed) != 0;
  header.format = static_cast<std::uint8_t> (header.format & ~compressed);
  if (header.format >= format_lengths.size())
    reader.fail ("its point data record format " + std::to_string (header.format) +
                 " is not 0 to 10");
  header.format_length = format_lengths.at (header.format);
  bytes.get (las_field::record_length, header.record_length);
  if (header.record_length < header.format_length)
    reader.fail ("its point data record length " +
                 std::to_string (header.record_length) +
                 " is too small for the format " + std::to_string (header.format));
}

void
readTransform (const HeaderReader& reader, const HeaderBytes& bytes, LasHeader& header)
{
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::size_t place = sizeof (double) * static_cast<std::size_t> (axis);
    bytes.get (las_field::scale + place, header.scale[axis]);
    bytes.get (las_field::offset + place, header.offset[axis]);
  }
  if (!header.scale.allFinite() || (header.scale.array() == 0.0).any())
    reader.fail ("a scale factor of its coordinates is zero or no number");
  if (!header.offset.allFinite())
    reader.fail ("an offset of its coordinates is no number");
}

void
readCounts (const HeaderReader& reader, const HeaderBytes& bytes, LasHeader& header)
{
  std::uint32_t legacy_points = 0;
  bytes.get (las_field::legacy_points, legacy_points);
  header.points = legacy_points;
  if (header.minor_version >= 3)
    bytes.get (las_field::waveform_offset, header.waveform_offset);
  if (header.minor_version < 4)
    return;
  bytes.get (las_field::evlr_offset, header.evlr_offset);
  bytes.get (las_field::evlr_count, header.evlr_count);
  bytes.get (las_field::points, header.points);
  if (header.points != 0 && legacy_points != 0 && header.points != legacy_points)
    reader.fail ("its numbers of points " + std::to_string (header.points) + " and " +
                 std::to_string (legacy_points) + " (legacy) differ");
  header.points = std::max<std::uint64_t> (header.points, legacy_points);
}

} // namespace

LasHeader
readLasHeader (HeaderReader& reader)
{
  const HeaderBytes bytes = headerBytesOf (reader);
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

std::string
readLasFront (HeaderReader& reader, const LasHeader& header)
{
  std::string front (header.points_offset, '\0');
  reader.goTo (0);
  reader.read (front.data(), front.size());
  return front;
}

void
relocateLas (const HeaderReader& reader,
             const LasHeader& header,
             std::uint64_t points_end,
             std::int64_t points_growth,
             std::string& front)
{
  setNumber (
      front, las_field::points_offset, static_cast<std::uint32_t> (front.size()));
  const auto move = [&] (std::size_t place, std::uint64_t offset) {
    // Unsigned sums wrap to what is meant where a copy is shorter.
    const bool is_behind = offset >= points_end && offset <= reader.fileSize();
    if (is_behind)
      offset += front.size() - header.points_offset +
                static_cast<std::uint64_t> (points_growth);
    setNumber (front, place, offset);
  };
  if (header.minor_version >= 3)
    move (las_field::waveform_offset, header.waveform_offset);
  if (header.minor_version >= 4)
    move (las_field::evlr_offset, header.evlr_offset);
}

void
copyRest (HeaderReader& reader, std::uint64_t begin, std::ostream& stream)
{
  constexpr std::uint64_t block = 1U << 20U;
  std::vector<char> bytes;
  reader.goTo (begin);
  for (std::uint64_t left = reader.fileSize() - begin; left > 0; left -= bytes.size()) {
    bytes.resize (std::min (block, left));
    reader.read (bytes.data(), bytes.size());
    stream.write (bytes.data(), static_cast<std::streamsize> (bytes.size()));
  }
}

} // namespace pcl_ops::apps

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

/** \brief What a header says, whether it makes sense or not.
 * \param[in] bytes as many as the longest has */
LasHeader
fieldsOf (const std::string& bytes)
{
  constexpr unsigned compressed = 0xc0;
  LasHeader header;
  const auto get = [&] (std::size_t place, auto& number) {
    number = fromLittleEndian<std::decay_t<decltype (number)>> (&bytes[place]);
  };
  get (las_field::major_version, header.major_version);
  get (las_field::minor_version, header.minor_version);
  get (las_field::header_size, header.size);
  get (las_field::points_offset, header.points_offset);
  get (las_field::vlr_count, header.vlr_count);
  get (las_field::format, header.format);
  header.says_laz = (header.format & compressed) != 0;
  header.format = static_cast<std::uint8_t> (header.format & ~compressed);
  get (las_field::record_length, header.record_length);
  get (las_field::legacy_points, header.legacy_points);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::size_t place = sizeof (double) * static_cast<std::size_t> (axis);
    get (las_field::scale + place, header.scale[axis]);
    get (las_field::offset + place, header.offset[axis]);
  }
  if (header.minor_version >= 3)
    get (las_field::waveform_offset, header.waveform_offset);
  if (header.minor_version >= 4) {
    get (las_field::evlr_offset, header.evlr_offset);
    get (las_field::evlr_count, header.evlr_count);
    get (las_field::points, header.points);
  }
  return header;
}

void
check (const LasHeader& header, const HeaderReader& reader)
{
  using std::to_string;
  const auto require = [&] (bool is_fine, const std::string& problem) {
    if (!is_fine)
      reader.fail (problem);
  };
  require (header.major_version == 1 && header.minor_version >= oldest_minor &&
               header.minor_version <= newest_minor,
           "its version " + to_string (header.major_version) + "." +
               to_string (header.minor_version) + " is not 1.2, 1.3 or 1.4");
  require (header.size >= header_lengths.at (header.minor_version - oldest_minor),
           "its header size " + to_string (header.size) +
               " is too small for its version");
  require (header.points_offset >= header.size &&
               header.points_offset <= reader.fileSize(),
           "its offset to point data " + to_string (header.points_offset) +
               " is within its header or behind its end");
  const std::string format = to_string (header.format);
  require (header.format < format_lengths.size(),
           "its point data record format " + format + " is not 0 to 10");
  require (header.record_length >= format_lengths.at (header.format),
           "its point data record length " + to_string (header.record_length) +
               " is too small for the format " + format);
  require (header.scale.allFinite() && (header.scale.array() != 0.0).all(),
           "a scale factor of its coordinates is zero or no number");
  require (header.offset.allFinite(), "an offset of its coordinates is no number");
  require (header.points == 0 || header.legacy_points == 0 ||
               header.points == header.legacy_points,
           "its numbers of points " + to_string (header.points) + " and " +
               to_string (header.legacy_points) + " (legacy) differ");
}

} // namespace

LasHeader
readLasHeader (HeaderReader& reader)
{
  std::string bytes (header_lengths.back(), '\0');
  reader.read (bytes.data(), std::min<std::size_t> (bytes.size(), reader.fileSize()));
  if (bytes.compare (0, 4, "LASF") != 0)
    reader.fail ("its first bytes are not LASF");
  if (reader.fileSize() < header_lengths.front())
    reader.fail ("it ends within its header");
  LasHeader header = fieldsOf (bytes);
  check (header, reader);
  header.format_length = format_lengths.at (header.format);
  header.points = std::max<std::uint64_t> (header.points, header.legacy_points);
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

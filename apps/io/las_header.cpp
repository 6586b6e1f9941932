// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_header.h"

#include <pcl/types.h>

#include <cli/errors.h>

#include <algorithm>
#include <array>
#include <limits>
#include <ostream>

namespace pcl_ops::apps {

namespace {

constexpr std::uint8_t oldest_minor = 2, newest_minor = 4;
/** \brief Of the versions 1.2, 1.3 and 1.4. */
constexpr std::array<std::uint16_t, 3> header_lengths = {227, 235, 375};
/** \brief Of the point data record formats 0 to 10. */
constexpr std::array<std::uint16_t, 11> format_lengths = {
    20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

/** \param[in] bytes as many as the longest header has */
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

constexpr std::uint64_t vlr_header = 54, evlr_header = 60;
constexpr std::uint64_t id_length = 16, description_size = 192, name_length = 32;
constexpr std::uint16_t extra_bytes_id = 4;
constexpr std::uint8_t undocumented_type = 0;
constexpr const char* specification = "LASF_Spec";

std::string
textIn (const char* bytes, std::size_t length)
{
  return {bytes, std::find (bytes, bytes + length, '\0')};
}

std::string
padded (std::string text, std::size_t length)
{
  text.resize (length, '\0');
  return text;
}

std::vector<LasVlr>
vlrsIn (HeaderReader& reader,
        std::uint64_t begin,
        std::uint64_t end,
        std::uint32_t count,
        std::uint64_t header_size)
{
  const auto check = [&] (std::uint64_t size) {
    if (size > end - begin)
      reader.fail ("a variable length record reaches beyond its place");
  };
  std::array<char, evlr_header> bytes{};
  std::vector<LasVlr> vlrs;
  for (; count > 0; --count) {
    check (header_size);
    reader.goTo (begin);
    reader.read (bytes.data(), header_size);
    const char* const length = &bytes[vlr_length_field];
    const std::uint64_t size = header_size == vlr_header
                                   ? fromLittleEndian<std::uint16_t> (length)
                                   : fromLittleEndian<std::uint64_t> (length);
    begin += header_size;
    check (size);
    vlrs.push_back ({begin - header_size,
                     begin,
                     begin + size,
                     textIn (&bytes[2], id_length),
                     fromLittleEndian<std::uint16_t> (&bytes[2 + id_length])});
    begin += size;
  }
  return vlrs;
}

bool
describesExtraBytes (const LasVlr& vlr)
{
  return vlr.user == specification && vlr.id == extra_bytes_id;
}

/** \return 0 for a type that does not exist */
std::uint64_t
extraBytesLength (std::uint8_t type, std::uint8_t options)
{
  constexpr std::array<std::uint8_t, 10> lengths = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  if (type == undocumented_type)
    return options;
  // Behind the single numbers are pairs and triples of them.
  const std::size_t count = 1 + (type - 1U) / lengths.size();
  return count > 3 ? 0 : count * lengths.at ((type - 1U) % lengths.size());
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
  header.points = std::max<std::uint64_t> (header.points, header.legacy_points);
  return header;
}

LasFrame::LasFrame (const std::string& name)
: file (name), reader (name, "LAS"), header (readLasHeader (reader))
{
  constexpr std::uint16_t laszip_id = 22204;
  vlrs_end = header.size;
  described_end = format_lengths.at (header.format);
  const auto set =
      [&] (std::optional<LasVlr>& single, const LasVlr& vlr, const char* kind) {
        if (single)
          reader.fail (std::string ("it has two ") + kind + " VLRs");
        single = vlr;
      };
  for (const LasVlr& vlr : vlrsIn (
           reader, header.size, header.points_offset, header.vlr_count, vlr_header)) {
    vlrs_end = vlr.end;
    if (vlr.user == "laszip encoded" && vlr.id == laszip_id)
      set (laszip, vlr, "LASzip");
    if (describesExtraBytes (vlr))
      set (extra_bytes, vlr, "Extra Bytes");
  }
  if (extra_bytes)
    readDescriptions();
}

void
LasFrame::readDescriptions()
{
  if (extra_bytes->size() % description_size != 0)
    reader.fail ("its Extra Bytes VLR ends within a description");
  const std::string content = bytes (extra_bytes->content, extra_bytes->end);
  for (std::size_t at = 0; at < content.size(); at += description_size) {
    const auto type = fromLittleEndian<std::uint8_t> (&content[at + 2]);
    const std::uint64_t length =
        extraBytesLength (type, fromLittleEndian<std::uint8_t> (&content[at + 3]));
    if (length == 0)
      reader.fail ("its Extra Bytes VLR has an unknown type, " + std::to_string (type));
    fields_.push_back ({textIn (&content[at + 4], name_length), type, described_end});
    described_end += length;
  }
  if (described_end > header.record_length)
    reader.fail ("its Extra Bytes VLR describes more bytes than its records have");
}

void
LasFrame::checkCount() const
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
LasFrame::checkEvlrs()
{
  if (header.evlr_count == 0)
    return;
  if (header.evlr_offset < header.pointsEnd() || header.evlr_offset > reader.fileSize())
    reader.fail ("its offset to extended variable length records is within its points "
                 "or behind its end");
  const auto vlrs = vlrsIn (
      reader, header.evlr_offset, reader.fileSize(), header.evlr_count, evlr_header);
  if (std::any_of (vlrs.begin(), vlrs.end(), describesExtraBytes))
    reader.fail ("its Extra Bytes are described behind its points");
}

std::string
LasFrame::bytes (std::uint64_t begin, std::uint64_t end)
{
  std::string bytes (end - begin, '\0');
  reader.goTo (begin);
  reader.read (bytes.data(), bytes.size());
  return bytes;
}

void
LasFrame::relocate (std::uint64_t points_end,
                    std::int64_t points_growth,
                    std::string& front) const
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
LasFrame::copyRest (std::uint64_t begin, std::ostream& stream)
{
  constexpr std::uint64_t block = 1U << 20U;
  for (const std::uint64_t size = reader.fileSize(); begin < size; begin += block)
    stream << bytes (begin, std::min (size, begin + block));
}

std::optional<std::uint64_t>
LasFrame::placeOf (const LasField& field) const
{
  for (const DescribedField& described : fields_)
    if (described.name == field.name && described.type == field.type)
      return described.place;
  return {};
}

bool
LasFrame::hasNamed (const LasField& field) const
{
  return std::any_of (fields_.begin(), fields_.end(), [&] (const auto& described) {
    return described.name == field.name;
  });
}

std::string
LasFrame::descriptionsOf (const std::vector<LasField>& added) const
{
  const std::uint64_t unknown = header.record_length - described_end;
  // Byte by byte: CloudCompare takes any number of undocumented bytes for one
  // (LasExtraScalarField::elementSize) and looks for what follows in the wrong place.
  constexpr std::uint64_t max_single = 64, longest = 255;
  std::string bytes;
  for (std::uint64_t left = unknown; left > 0;) {
    const auto length =
        std::uint8_t (unknown > max_single ? std::min (left, longest) : 1);
    bytes += descriptionOf ({"", undocumented_type, "", "", length});
    left -= length;
  }
  for (const LasField& field : added)
    bytes += descriptionOf (field);
  return bytes;
}

std::string
descriptionOf (const LasField& field)
{
  const std::string begin = littleEndian<std::uint16_t> (0) +
                            littleEndian (field.type) + littleEndian (field.options) +
                            padded (field.name, name_length);
  return padded (begin, description_size - name_length) +
         padded (field.text, name_length);
}

std::string
extraBytesVlr (const std::string& content)
{
  return littleEndian<std::uint16_t> (0) + padded (specification, id_length) +
         littleEndian (extra_bytes_id) +
         littleEndian (static_cast<std::uint16_t> (content.size())) +
         padded ("Extra Bytes", name_length) + content;
}

} // namespace pcl_ops::apps

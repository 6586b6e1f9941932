// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_header.h"

#include <pcl/types.h>

#include "las_file.h"
#include <cli/errors.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <ostream>

namespace pcl_ops::apps {

namespace {

constexpr std::uint8_t newest_minor_version = 4;

/** \brief The ids of an Extra Bytes VLR. */
constexpr std::uint16_t extra_bytes_record_id = 4;
constexpr const char* extra_bytes_user_id = "LASF_Spec";

/** \brief The description of a field in an Extra Bytes VLR, in its byte layout. */
struct Description {
  LasHeader::UInt16 reserved;
  std::uint8_t type, options;
  std::array<char, 32> name;
  std::array<char, 124> limits_and_scales;
  std::array<char, 32> text;
};
static_assert (sizeof (Description) == 192, "as in LAS 1.4");

/** \brief Returns the text in a field of fixed size, which ends at the first zero. */
template <std::size_t size>
std::string
textIn (const std::array<char, size>& bytes)
{
  return {bytes.begin(), std::find (bytes.begin(), bytes.end(), '\0')};
}

/** \brief Returns the number of bytes of a field of extra bytes; 0 for a type that does
 * not exist. */
std::uint64_t
extraBytesLength (const LasField& field)
{
  if (field.type == las_undocumented)
    return field.options;
  // Types 1 to 10 are single numbers, 11 to 20 pairs of them, 21 to 30 triples.
  constexpr std::array<std::uint8_t, 10> number_lengths = {
      1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  constexpr std::size_t max_count = 3;
  const std::size_t count = 1 + (field.type - 1U) / number_lengths.size();
  const std::size_t number_type = (field.type - 1U) % number_lengths.size();
  return count > max_count ? 0 : count * number_lengths.at (number_type);
}

/** \brief Returns the number of bytes of the header in its version, 1.0 to 1.4. */
std::size_t
headerLength (const LasHeader& header)
{
  constexpr std::size_t las_1_3_header_size = 235;
  constexpr std::array<std::size_t, 5> lengths = {las_1_2_header_size,
                                                  las_1_2_header_size,
                                                  las_1_2_header_size,
                                                  las_1_3_header_size,
                                                  sizeof (header)};
  return lengths.at (header.minor_version);
}

/** \brief Returns the number of bytes of a record in a point data record format,
 * without extra bytes; 0 if there is no such format. */
std::uint16_t
minRecordLength (std::uint8_t format)
{
  constexpr std::array<std::uint16_t, 11> lengths = {
      20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  return format < lengths.size() ? lengths.at (format) : 0;
}

Eigen::Vector3d
toEigen (const LasHeader::Vector& vector)
{
  return {vector[0], vector[1], vector[2]};
}

/** \throws WorkError if the header contradicts itself or the length of the file */
void
checkHeader (const LasHeader& header, const FileReader& reader)
{
  using std::to_string;
  const auto require = [&] (bool is_fine, const std::string& problem) {
    if (!is_fine)
      reader.fail (problem);
  };
  require (header.header_size >= headerLength (header),
           "its header size " + to_string (header.header_size) +
               " is too small for its version");
  require (header.points_offset >= header.header_size &&
               header.points_offset <= reader.fileSize(),
           "its offset to point data " + to_string (header.points_offset) +
               " is within its header or behind its end");
  const std::string format = to_string (header.pointFormat());
  const std::uint16_t min_length = minRecordLength (header.pointFormat());
  require (min_length > 0,
           "its point data record format " + format + " is not 0 to 10");
  require (header.record_length >= min_length,
           "its point data record length " + to_string (header.record_length) +
               " is too small for the format " + format);
  const Eigen::Vector3d scale = toEigen (header.scale);
  require (scale.allFinite() && (scale.array() != 0.0).all(),
           "a scale factor of its coordinates is zero or no number");
  require (toEigen (header.offset).allFinite(),
           "an offset of its coordinates is no number");
  require (header.point_count == 0 || header.legacy_point_count == 0 ||
               header.point_count == header.legacy_point_count,
           "its numbers of points " + to_string (header.point_count) + " and " +
               to_string (header.legacy_point_count) + " (legacy) differ");
}

/** \brief In LAS 1.0 two bytes mark the beginning of the points. By the specification
 * LasHeader::points_offset is the offset of the points behind this mark, but some
 * writers store the offset of the mark.
 * \return the length of the mark [bytes] if it is at LasHeader::points_offset, else 0
 */
std::uint32_t
lengthOfMark (const LasHeader& header, FileReader& reader)
{
  constexpr std::uint16_t mark = 0xccdd;
  const bool has_room = header.pointsEnd() + sizeof (mark) <= reader.fileSize();
  return header.minor_version == 0 && has_room &&
                 reader.readAt<LasHeader::UInt16> (header.points_offset) == mark
             ? sizeof (mark)
             : 0;
}

/** \brief Reads where \p count variable length records are, which follow one another
 * from the offset \p begin on, and their ids.
 * \tparam Length as of LasVlrHeader
 * \throws WorkError if they reach beyond the offset \p end */
template <typename Length>
std::vector<LasVlr>
readVlrs (FileReader& reader,
          std::uint64_t begin,
          std::uint64_t end,
          std::uint32_t count)
{
  std::uint64_t offset = begin;
  const auto require_room = [&] (std::uint64_t size) {
    if (size > end - offset)
      reader.fail ("a variable length record reaches beyond its place");
  };
  std::vector<LasVlr> vlrs;
  for (std::uint32_t i = 0; i < count; ++i) {
    require_room (sizeof (LasVlrHeader<Length>));
    const auto header = reader.readAt<LasVlrHeader<Length>> (offset);
    LasVlr& vlr = vlrs.emplace_back();
    vlr.begin = offset;
    vlr.content = offset + sizeof (header);
    vlr.end = vlr.content + header.content_length;
    vlr.user_id = textIn (header.user_id);
    vlr.record_id = header.record_id;
    offset = vlr.content;
    require_room (header.content_length);
    offset = vlr.end;
  }
  return vlrs;
}

bool
describesExtraBytes (const LasVlr& vlr)
{
  return vlr.user_id == extra_bytes_user_id && vlr.record_id == extra_bytes_record_id;
}

/** \brief Returns the fields that an Extra Bytes VLR describes.
 * \param[in,out] fields_end offset in a record [bytes]: before the call that of the
 * first field, after it that of the end of the last field */
std::vector<LasField>
describedFields (const LasVlr& vlr, FileReader& reader, std::uint64_t& fields_end)
{
  if (vlr.contentSize() % sizeof (Description) != 0)
    reader.fail ("its Extra Bytes VLR ends within a description");
  std::vector<LasField> fields;
  for (std::uint64_t offset = vlr.content; offset < vlr.end;
       offset += sizeof (Description)) {
    const auto description = reader.readAt<Description> (offset);
    LasField& field = fields.emplace_back();
    field.name = textIn (description.name);
    field.type = description.type;
    field.options = description.options;
    field.offset = fields_end;
    fields_end += extraBytesLength (field);
    if (fields_end == field.offset)
      reader.fail ("its Extra Bytes VLR has an unknown type, " +
                   std::to_string (field.type));
  }
  return fields;
}

} // namespace

LasHeader
readLasHeader (FileReader& reader)
{
  LasHeader header{};
  auto* const bytes = reinterpret_cast<char*> (&header);
  reader.read (bytes, std::min<std::uint64_t> (sizeof (header), reader.fileSize()));
  if (std::string (bytes, 4) != "LASF")
    reader.fail ("its first bytes are not LASF");
  if (reader.fileSize() < las_1_2_header_size)
    reader.fail ("it ends within its header");
  if (header.major_version != 1 || header.minor_version > newest_minor_version)
    reader.fail ("its version " + std::to_string (header.major_version) + "." +
                 std::to_string (header.minor_version) + " is not 1.0 to 1.4");
  std::fill (bytes + headerLength (header), bytes + sizeof (header), '\0');
  checkHeader (header, reader);
  header.points_offset += lengthOfMark (header, reader);
  return header;
}

std::string
descriptionOf (const LasField& field)
{
  Description description{};
  description.type = field.type;
  description.options = field.options;
  field.name.copy (description.name.data(), description.name.size());
  field.description.copy (description.text.data(), description.text.size());
  return bytesOf (description);
}

std::string
extraBytesVlr (const std::string& descriptions, std::uint8_t minor_version)
{
  constexpr std::uint16_t signature_of_1_0 = 0xaabb; // 0 in later versions
  LasStandardVlrHeader header{};
  if (minor_version == 0)
    header.reserved = signature_of_1_0;
  std::strcpy (header.user_id.data(), extra_bytes_user_id);
  header.record_id = extra_bytes_record_id;
  header.content_length = static_cast<std::uint16_t> (descriptions.size());
  std::strcpy (header.description.data(), "Extra Bytes");
  return bytesOf (header) + descriptions;
}

LasFile::LasFile (const std::string& name, const std::string& name_in_messages)
: file (name_in_messages.empty() ? name : name_in_messages)
, reader (name, "LAS", name_in_messages)
, header (readLasHeader (reader))
, coordinate_scale (toEigen (header.scale))
, coordinate_offset (toEigen (header.offset))
, vlrs_end (header.header_size)
, fields_end (minRecordLength (header.pointFormat()))
{
  constexpr std::uint16_t laszip_id = 22204;
  constexpr std::uint16_t wkt_id = 2112;
  constexpr std::uint16_t geo_keys_id = 34735;
  constexpr const char* projection_user_id = "LASF_Projection";
  const auto set_once =
      [&] (std::optional<LasVlr>& member, const LasVlr& vlr, const char* kind) {
        if (member)
          reader.fail (std::string ("it has two ") + kind + " VLRs");
        member = vlr;
      };
  for (const LasVlr& vlr : readVlrs<LasHeader::UInt16> (
           reader, header.header_size, header.points_offset, header.vlr_count)) {
    vlrs_end = vlr.end;
    if (vlr.user_id == "laszip encoded" && vlr.record_id == laszip_id)
      set_once (laszip, vlr, "LASzip");
    if (describesExtraBytes (vlr))
      set_once (extra_bytes, vlr, "Extra Bytes");
    if (vlr.user_id == projection_user_id && vlr.record_id == wkt_id)
      wkt = vlr;
    if (vlr.user_id == projection_user_id && vlr.record_id == geo_keys_id)
      geo_keys = vlr;
  }
  if (extra_bytes)
    readFields (*extra_bytes);
}

void
LasFile::readFields (const LasVlr& vlr)
{
  fields = describedFields (vlr, reader, fields_end);
  if (fields_end > header.record_length)
    reader.fail ("its Extra Bytes VLR describes more bytes than its records have");
}

void
LasFile::checkCount() const
{
  constexpr auto max_points = std::numeric_limits<pcl::index_t>::max();
  if (size() == 0)
    reader.failEmpty();
  if (size() > static_cast<std::uint64_t> (max_points))
    throw WorkError (file,
                     "has " + std::to_string (size()) + " points, more than " +
                         std::to_string (max_points) + "; split it into tiles");
}

void
LasFile::checkPoints()
{
  if (size() > (reader.fileSize() - header.points_offset) / header.record_length)
    reader.failTruncated();
  checkCount();
  if (header.evlr_count == 0)
    return;
  if (header.evlr_offset < header.pointsEnd() || header.evlr_offset > reader.fileSize())
    reader.fail ("its offset to extended variable length records is within its points "
                 "or behind its end");
  const auto vlrs = readVlrs<LasHeader::UInt64> (
      reader, header.evlr_offset, reader.fileSize(), header.evlr_count);
  for (const LasVlr& vlr : vlrs)
    if (describesExtraBytes (vlr)) {
      if (extra_bytes || has_extra_bytes_evlr)
        reader.fail ("it has two Extra Bytes VLRs");
      has_extra_bytes_evlr = true;
      readFields (vlr);
    }
}

void
LasFile::replaceHeader (LasHeader copy_header,
                        std::uint64_t points_end,
                        std::uint64_t copy_points_end,
                        std::string& front) const
{
  copy_header.points_offset = static_cast<std::uint32_t> (front.size());
  for (LasHeader::UInt64* offset :
       {&copy_header.waveform_offset, &copy_header.evlr_offset}) {
    const bool is_behind_points = *offset >= points_end && *offset <= reader.fileSize();
    // If the copy is shorter, the unsigned difference wraps, and the sum wraps back.
    if (is_behind_points)
      *offset += copy_points_end - points_end;
  }
  const std::size_t length = headerLength (copy_header);
  front.replace (0, length, reinterpret_cast<const char*> (&copy_header), length);
}

void
LasFile::copyFrom (std::uint64_t begin, std::ostream& stream)
{
  constexpr std::uint64_t block_size = 1U << 20U; // [bytes]
  const std::uint64_t end = reader.fileSize();
  for (; begin < end; begin += block_size)
    stream << bytes (begin, std::min (end, begin + block_size));
}

} // namespace pcl_ops::apps

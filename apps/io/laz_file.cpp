// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laz_file.h"

#include "las_header.h"
#include "laszip_points.h"
#include "output_file.h"
#include <cli/errors.h>

#include <algorithm>
#include <array>
#include <limits>
#include <ostream>

namespace pcl_ops::apps {

bool
isLazName (const std::string& file)
{
  return extensionOf (file) == ".laz";
}

bool
isLasName (const std::string& file)
{
  return extensionOf (file) == ".las" || isLazName (file);
}

bool
isCompressedLas (const std::string& file)
{
  HeaderReader reader (file, "LAS");
  const LasHeader header = readLasHeader (reader);
  return header.says_laz || readLasVlrs (reader, header).laszip;
}

#ifdef PCL_OPS_WITH_LASZIP

namespace {

constexpr std::uint8_t compressed = 0x80;
/** \brief How LASzip calls points that are not in chunks. */
constexpr char in_one_chunk = 1;

/** \brief Where the points end: no field of a header says it. */
std::uint64_t
endOfCompressed (const HeaderReader& reader, const LasHeader& header)
{
  std::uint64_t end = reader.fileSize();
  for (const std::uint64_t next : {header.waveform_offset, header.evlr_offset})
    if (next > header.points_offset)
      end = std::min (end, next);
  return end;
}

template <typename Integer>
Integer
integerAt (HeaderReader& reader, std::uint64_t place)
{
  std::array<char, sizeof (Integer)> bytes{};
  reader.goTo (place);
  reader.read (bytes.data(), bytes.size());
  return fromLittleEndian<Integer> (bytes.data());
}

/** \brief The LASzip VLR's content.
 * \throws WorkError if it does not describe such points: LASzip believes it, and would
 * crash */
std::string
checkedDescription (HeaderReader& reader,
                    const LasHeader& header,
                    const LasVlr& laszip,
                    const std::string& file)
{
  constexpr std::size_t free_begin = 4, free_end = 32, items = 34, item_size = 6,
                        version_at = 4, version_size = 2;
  constexpr unsigned newest_in_one_chunk = 5;
  std::string expected =
      laszipVlr (file, header).substr (laszip.content - laszip.begin);
  std::string content (laszip.end - laszip.content, '\0');
  if (content.size() != expected.size())
    failDamagedPoints (file);
  reader.goTo (laszip.content);
  reader.read (content.data(), content.size());
  const auto take = [&] (std::size_t begin, std::size_t size) {
    expected.replace (begin, size, content, begin, size);
  };
  take (free_begin, free_end - free_begin);
  for (std::size_t item = items; item < expected.size(); item += item_size)
    take (item + version_at, version_size);
  if (content[0] == in_one_chunk && header.format <= newest_in_one_chunk)
    take (0, 1);
  if (content != expected)
    failDamagedPoints (file);
  return content;
}

/** \brief Refuses points in chunks whose table is not where it is said to be or has
 * another length: LASzip would crash, or allocate what the table says. On chunks see
 * M. Isenburg, LASzip: lossless compression of lidar data, Photogrammetric Engineering
 * and Remote Sensing 79 (2), 2013. */
void
checkChunkTable (HeaderReader& reader,
                 const LasHeader& header,
                 std::uint32_t size,
                 const std::string& file)
{
  constexpr std::uint64_t head = 8;
  constexpr std::uint32_t of_any_size = std::numeric_limits<std::uint32_t>::max();
  constexpr std::uint64_t at_end = std::numeric_limits<std::uint64_t>::max();
  const auto check = [&] (bool is_good) {
    if (!is_good)
      failDamagedPoints (file);
  };
  const std::uint64_t begin = header.points_offset + head, end = reader.fileSize();
  check (begin + head <= end && size > 0);
  auto table = integerAt<std::uint64_t> (reader, header.points_offset);
  if (table == at_end)
    table = integerAt<std::uint64_t> (reader, end - head);
  check (begin <= table && table <= end - head);
  const std::uint64_t chunks = integerAt<std::uint32_t> (reader, table + 4);
  // Each begins with a point that is not compressed.
  check (integerAt<std::uint32_t> (reader, table) == 0 && chunks > 0 &&
         chunks <= (end - begin) / header.record_length);
  check (size == of_any_size || chunks == (header.points + size - 1) / size);
}

void
checkCompression (HeaderReader& reader,
                  const LasHeader& header,
                  const LasVlr& laszip,
                  const std::string& file)
{
  constexpr std::size_t chunk_size_at = 12;
  const std::string content = checkedDescription (reader, header, laszip, file);
  if (content[0] != in_one_chunk)
    checkChunkTable (reader,
                     header,
                     fromLittleEndian<std::uint32_t> (&content[chunk_size_at]),
                     file);
}

} // namespace

bool
hasLaszip ()
{
  return true;
}

void
decompressLaz (const std::string& file, std::ostream& stream)
{
  HeaderReader reader (file, "LAS");
  const LasHeader header = readLasHeader (reader);
  const LasExtraBytes extra = readLasVlrs (reader, header);
  checkLasCount (reader, header, file);
  std::string front = readLasFront (reader, header);
  setNumber (front, las_field::format, header.format);
  if (extra.laszip) {
    const LasVlr& laszip = *extra.laszip;
    checkCompression (reader, header, laszip, file);
    setNumber (front, las_field::vlr_count, header.vlr_count - 1);
    front.erase (laszip.begin, laszip.end - laszip.begin);
  }
  const std::uint64_t end = endOfCompressed (reader, header);
  relocateLas (
      reader, header, end, static_cast<std::int64_t> (header.pointsEnd() - end), front);
  stream << front;
  convertPoints (file, header, PointsAs::Plain, stream);
  copyRest (reader, end, stream);
}

void
compressLas (const std::string& file, std::ostream& stream)
{
  HeaderReader reader (file, "LAS");
  const LasHeader header = readLasHeader (reader);
  const LasExtraBytes extra = readLasVlrs (reader, header);
  std::string front = readLasFront (reader, header);
  setNumber (front, las_field::format, std::uint8_t (header.format | compressed));
  setNumber (front, las_field::vlr_count, header.vlr_count + 1);
  front.insert (extra.vlrs_end, laszipVlr (file, header));
  stream << front;
  convertPoints (file, header, PointsAs::Compressed, stream);
  const auto end = static_cast<std::int64_t> (std::streamoff (stream.tellp()));
  copyRest (reader, header.pointsEnd(), stream);
  // How much shorter the points are is known only now.
  const auto size = static_cast<std::int64_t> (front.size());
  const auto plain = static_cast<std::int64_t> (header.points * header.record_length);
  relocateLas (reader, header, header.pointsEnd(), end - size - plain, front);
  stream.seekp (0);
  stream << front;
  stream.seekp (0, std::ios::end);
}

#else

bool
hasLaszip ()
{
  return false;
}

void
decompressLaz (const std::string& file, std::ostream&)
{
  throw WorkError (file, "is compressed (LAZ); decompress it, e.g. by laszip or pdal");
}

void
compressLas (const std::string& file, std::ostream& stream)
{
  decompressLaz (file, stream);
}

#endif

} // namespace pcl_ops::apps

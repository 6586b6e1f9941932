// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_file.h"
#include <cli/errors.h>
#ifdef PCL_OPS_WITH_LASZIP
#include <cli/program.h>
#include <laszip/laszip_api.h>

#include <algorithm>
#include <limits>
#include <ostream>
#endif

namespace pcl_ops::apps {

#ifdef PCL_OPS_WITH_LASZIP

namespace {

constexpr std::uint8_t compressed = 0x80;
/** \brief LASzip's number of the compressor that does not divide points into chunks. */
constexpr char in_one_chunk = 1;

[[noreturn]] void
failDamagedPoints (const std::string& file)
{
  throw WorkError (file,
                   "is truncated or damaged: its points cannot be decompressed; copy "
                   "or write it again");
}

/** \brief A handle of LASzip, for a reader or a writer. */
struct Laszip {
  explicit Laszip (std::string name) : file (std::move (name))
  {
    if (laszip_create (&handle) != 0)
      throw std::bad_alloc();
  }
  Laszip (const Laszip&) = delete;
  Laszip&
  operator= (const Laszip&) = delete;
  ~Laszip()
  {
    if (handle == nullptr)
      return;
    // Closes the one that is open, which laszip_destroy does not.
    laszip_close_reader (handle);
    laszip_close_writer (handle);
    laszip_destroy (handle);
  }

  void
  check (laszip_I32 failed) const
  {
    if (failed == 0)
      return;
    laszip_CHAR* reason = nullptr;
    laszip_get_error (handle, &reason);
    // LASzip reports a failed allocation like this.
    if (reason != nullptr && std::string (reason).rfind ("internal error", 0) == 0)
      throw std::bad_alloc();
    failDamagedPoints (file);
  }

  void
  setForm (const LasHeader& header) const
  {
    check (laszip_set_point_type_and_size (
        handle, header.pointFormat(), header.record_length));
  }

  std::string file;
  laszip_POINTER handle = nullptr;
};

/** \throws WorkError if LASzip cannot compress points of this format */
std::string
laszipVlr (const LasFile& las)
{
  const Laszip writer (las.file);
  writer.setForm (las.header);
  laszip_U8* bytes = nullptr;
  laszip_U32 size = 0;
  writer.check (laszip_create_laszip_vlr (writer.handle, &bytes, &size));
  return {reinterpret_cast<const char*> (bytes), size};
}

/** \throws WorkError if the points are damaged, Interrupted */
void
convertPoints (const LasFile& las, bool compresses, std::ostream& stream)
{
  const std::string& file = las.file;
  constexpr std::uint64_t block = 1U << 14U;
  const Laszip reader (file);
  Laszip writer (file);
  laszip_BOOL is_compressed = 0;
  reader.check (laszip_open_reader (reader.handle, file.c_str(), &is_compressed));
  writer.setForm (las.header);
  writer.check (
      laszip_open_writer_stream (writer.handle, stream, compresses ? 1 : 0, 1));
  laszip_point* from = nullptr;
  reader.check (laszip_get_point_pointer (reader.handle, &from));
  for (std::uint64_t i = 0; i < las.size(); ++i) {
    if (i % block == 0)
      stopIfInterrupted();
    reader.check (laszip_read_point (reader.handle));
    writer.check (laszip_set_point (writer.handle, from));
    const laszip_I32 failed = laszip_write_point (writer.handle);
    if (!stream)
      break;
    writer.check (failed);
  }
  if (stream && laszip_close_writer (writer.handle) == 0)
    return;
  // LASzip would crash if it closed a writer that failed.
  writer.handle = nullptr;
  if (stream) // else the owner of the stream reports its failure
    throw std::bad_alloc();
}

/** \brief Returns the content of the LASzip VLR.
 * \throws WorkError if it does not fit the format of the points: LASzip would crash */
std::string
checkedDescription (LasFile& las, const LasVlr& laszip)
{
  constexpr std::size_t free_begin = 4, free_end = 32, items = 34, item_size = 6,
                        version_at = 4, version_size = 2;
  constexpr unsigned newest_in_one_chunk = 5;
  std::string expected = laszipVlr (las).substr (laszip.content - laszip.begin);
  if (laszip.size() != expected.size())
    failDamagedPoints (las.file);
  const std::string content = las.bytes (laszip.content, laszip.end);
  const auto take = [&] (std::size_t begin, std::size_t size) {
    expected.replace (begin, size, content, begin, size);
  };
  take (free_begin, free_end - free_begin);
  for (std::size_t item = items; item < expected.size(); item += item_size)
    take (item + version_at, version_size);
  if (content[0] == in_one_chunk && las.header.pointFormat() <= newest_in_one_chunk)
    take (0, 1);
  if (content != expected)
    failDamagedPoints (las.file);
  return content;
}

/** \brief Refuses points at which LASzip would crash: their description is wrong, or
 * the chunk table has an impossible position or length. On chunks see M. Isenburg,
 * LASzip, Photogrammetric Engineering and Remote Sensing 79 (2), 2013. */
void
checkCompression (LasFile& las)
{
  struct Chunks {
    LasHeader::Long version, count;
  };
  constexpr std::uint64_t chunk_size_at = 12, head = sizeof (Chunks);
  constexpr std::uint32_t of_any_size = std::numeric_limits<std::uint32_t>::max();
  constexpr std::uint64_t at_end = std::numeric_limits<std::uint64_t>::max();
  if (checkedDescription (las, *las.laszip)[0] == in_one_chunk)
    return;
  HeaderReader& reader = las.reader;
  const std::uint32_t size =
      reader.at<LasHeader::Long> (las.laszip->content + chunk_size_at);
  const auto check = [&] (bool is_good) {
    if (!is_good)
      failDamagedPoints (las.file);
  };
  const LasHeader& header = las.header;
  const std::uint64_t begin = header.points_offset + head, end = reader.fileSize();
  check (begin + head <= end && size > 0);
  std::uint64_t table = reader.at<LasHeader::LongLong> (header.points_offset);
  if (table == at_end)
    table = reader.at<LasHeader::LongLong> (end - head);
  check (begin <= table && table <= end - head);
  const auto chunks = reader.at<Chunks> (table);
  // The first point of each chunk is not compressed.
  check (chunks.version == 0 && chunks.count > 0 &&
         chunks.count <= (end - begin) / header.record_length);
  check (size == of_any_size || chunks.count == (las.size() + size - 1) / size);
}

} // namespace

void
decompressLaz (const std::string& file, std::ostream& stream)
{
  LasFile las (file);
  const LasHeader& header = las.header;
  las.checkCount();
  std::string front = las.bytes (0, header.points_offset);
  LasHeader plain = header;
  plain.format = header.pointFormat();
  if (las.laszip) {
    checkCompression (las);
    --plain.vlr_count;
    front.erase (las.laszip->begin, las.laszip->end - las.laszip->begin);
  }
  // No field of the header tells where compressed points end.
  std::uint64_t end = las.reader.fileSize();
  for (const std::uint64_t next : {header.waveform_offset, header.evlr_offset})
    if (next > header.points_offset)
      end = std::min (end, next);
  const std::uint64_t plain_size = las.size() * header.record_length;
  las.putHeader (plain, end, front.size() + plain_size, front);
  stream << front;
  convertPoints (las, false, stream);
  las.copyRest (end, stream);
}

void
compressLas (const std::string& file, std::ostream& stream)
{
  LasFile las (file);
  LasHeader header = las.header;
  header.format = header.pointFormat() | compressed;
  ++header.vlr_count;
  std::string front = las.bytes (0, header.points_offset);
  front.insert (las.vlrs_end, laszipVlr (las));
  stream << front;
  convertPoints (las, true, stream);
  // The end of the compressed points is known only now.
  const auto end = static_cast<std::uint64_t> (std::streamoff (stream.tellp()));
  las.copyRest (header.pointsEnd(), stream);
  las.putHeader (header, header.pointsEnd(), end, front);
  stream.seekp (0);
  stream << front;
  stream.seekp (0, std::ios::end);
}

bool
hasLaszip ()
{
  return true;
}

#else

void
decompressLaz (const std::string& file, std::ostream&)
{
  throw WorkError (
      file,
      "is compressed (LAZ), and this build has no LASzip; build again with "
      "liblaszip-dev, on Debian 12 with LASzip's source (files.md), or "
      "decompress it, e.g. by laspy[lazrs] of Python");
}

void
compressLas (const std::string& file, std::ostream& stream)
{
  decompressLaz (file, stream);
}

bool
hasLaszip ()
{
  return false;
}

#endif

} // namespace pcl_ops::apps

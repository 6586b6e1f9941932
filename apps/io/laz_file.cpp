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

/** \brief The bit of LasHeader::format_bits that LASzip sets for compressed points. */
constexpr std::uint8_t compressed_bit = 0x80;
/** \brief The compressor that does not divide the points into chunks. The number of the
 * compressor is the first byte of the content of a LASzip VLR. */
constexpr char without_chunks = 1;

[[noreturn]] void
failDamagedPoints (const std::string& file)
{
  throw WorkError (file,
                   "is truncated or damaged: its points cannot be converted by LASzip; "
                   "copy or write it again");
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
    // Closes the reader or the writer, if one is open: laszip_destroy does not.
    laszip_close_reader (handle);
    laszip_close_writer (handle);
    laszip_destroy (handle);
  }

  /** \param[in] error what a function of LASzip returned; 0 is success
   * \throws std::bad_alloc if memory ran out, WorkError for other errors */
  void
  check (laszip_I32 error) const
  {
    if (error == 0)
      return;
    throwIfOutOfMemory();
    failDamagedPoints (file);
  }

  /** \throws std::bad_alloc, or WorkError if LASzip does not know the point format */
  void
  setPointFormat (const LasHeader& header) const
  {
    const bool is_known = laszip_set_point_type_and_size (
                              handle, header.pointFormat(), header.record_length) == 0;
    if (is_known)
      return;
    throwIfOutOfMemory();
    throw WorkError (file,
                     "has points of format " + std::to_string (header.pointFormat()) +
                         " in " + std::to_string (header.record_length) +
                         " bytes, which this LASzip does not know; build with a newer "
                         "one");
  }

  /** \brief The name of the file in messages. */
  std::string file;
  laszip_POINTER handle = nullptr;

private:
  /** \brief Throws std::bad_alloc if the last function of LASzip failed for lack of
   * memory. Call it when a function has failed. */
  void
  throwIfOutOfMemory () const
  {
    laszip_CHAR* reason = nullptr;
    laszip_get_error (handle, &reason);
    // LASzip reports a failed allocation like this, as any exception in its own code.
    if (reason != nullptr && std::string (reason).rfind ("internal error", 0) == 0)
      throw std::bad_alloc();
  }
};

/** \brief Returns the VLR that LASzip writes for the point format of a file, header and
 * content.
 * \throws WorkError if LASzip does not know this format */
std::string
newLaszipVlr (const LasFile& las)
{
  const Laszip writer (las.file);
  writer.setPointFormat (las.header);
  laszip_U8* bytes = nullptr;
  laszip_U32 size = 0;
  writer.check (laszip_create_laszip_vlr (writer.handle, &bytes, &size));
  return {reinterpret_cast<const char*> (bytes), size};
}

enum class Conversion { Compress, Decompress };

/** \brief Writes the points of a file to a stream: compressed points decompressed, or
 * the reverse.
 * \throws WorkError if the points are damaged, Interrupted; std::bad_alloc if LASzip
 * fails to write while the stream is good */
void
convertPoints (const LasFile& las, Conversion conversion, std::ostream& stream)
{
  // The name in messages is the path, too: both callers open the file itself.
  const std::string& file = las.file;
  // So few that the user hardly waits; chosen by hand.
  constexpr std::uint64_t points_between_checks = 1U << 14U;
  constexpr laszip_BOOL write_no_header = 1; // the caller writes it
  const Laszip reader (file);
  Laszip writer (file);
  laszip_BOOL is_compressed = 0;
  reader.check (laszip_open_reader (reader.handle, file.c_str(), &is_compressed));
  writer.setPointFormat (las.header);
  const laszip_BOOL compress = conversion == Conversion::Compress ? 1 : 0;
  writer.check (
      laszip_open_writer_stream (writer.handle, stream, compress, write_no_header));
  laszip_point* point = nullptr;
  reader.check (laszip_get_point_pointer (reader.handle, &point));
  bool is_written = !stream.fail();
  for (std::uint64_t i = 0; i < las.size() && is_written; ++i) {
    if (i % points_between_checks == 0)
      stopIfInterrupted();
    reader.check (laszip_read_point (reader.handle));
    writer.check (laszip_set_point (writer.handle, point));
    is_written = laszip_write_point (writer.handle) == 0 && !stream.fail();
  }
  if (is_written && laszip_close_writer (writer.handle) == 0)
    return;
  // LASzip would crash if ~Laszip closed a writer that failed. Its memory is lost.
  writer.handle = nullptr;
  if (stream) // else the owner of the stream reports its failure
    throw std::bad_alloc();
}

/** \brief Returns the content of the LASzip VLR.
 * \throws WorkError if it does not fit the format of the points: LASzip would crash */
std::string
checkedLaszipContent (LasFile& las, const LasVlr& laszip)
{
  // Offsets and lengths in the content [bytes]. At 0 is the compressor, from 4 up to 32
  // are versions, options and the size of chunks, from 34 on the items of a point, each
  // with type, size and version.
  constexpr std::size_t compressor_length = 1;
  constexpr std::size_t options_begin = 4, options_end = 32;
  constexpr std::size_t items_begin = 34, item_length = 6;
  constexpr std::size_t version_in_item = 4, version_length = 2;
  constexpr unsigned last_format_without_chunks = 5; // newer ones need chunks
  std::string expected = newLaszipVlr (las).substr (laszip.content - laszip.begin);
  if (laszip.contentSize() != expected.size())
    failDamagedPoints (las.file);
  const std::string content = las.bytes (laszip.content, laszip.end);
  const auto accept_any = [&] (std::size_t begin, std::size_t length) {
    expected.replace (begin, length, content, begin, length);
  };
  accept_any (options_begin, options_end - options_begin);
  for (std::size_t item = items_begin; item < expected.size(); item += item_length)
    accept_any (item + version_in_item, version_length);
  if (content[0] == without_chunks &&
      las.header.pointFormat() <= last_format_without_chunks)
    accept_any (0, compressor_length);
  if (content != expected)
    failDamagedPoints (las.file);
  return content;
}

/** \brief Refuses a file at which LASzip would crash: the description of its points is
 * wrong, or its chunk table has an impossible offset or length. On chunks see M.
 * Isenburg, LASzip, Photogrammetric Engineering and Remote Sensing 79 (2), 2013.
 * \throws WorkError for such a file */
void
checkCompression (LasFile& las)
{
  struct TableHeader {
    LasHeader::UInt32 version, chunk_count;
  };
  constexpr std::uint64_t chunk_size_in_content = 12; // offset [bytes]
  // The chunk size of a file whose chunks have different numbers of points.
  constexpr std::uint32_t sizes_differ = std::numeric_limits<std::uint32_t>::max();
  // What is in front of the chunks if the offset of their table is at the end instead.
  constexpr std::uint64_t table_offset_at_end =
      std::numeric_limits<std::uint64_t>::max();
  if (checkedLaszipContent (las, *las.laszip)[0] == without_chunks)
    return;
  FileReader& reader = las.reader;
  const std::uint32_t chunk_size = // [points]
      reader.readAt<LasHeader::UInt32> (las.laszip->content + chunk_size_in_content);
  const auto check = [&] (bool is_good) {
    if (!is_good)
      failDamagedPoints (las.file);
  };
  const LasHeader& header = las.header;
  // The offset of the chunk table is in front of the chunks, or at the end of the file.
  const std::uint64_t chunks_begin = header.points_offset + sizeof (LasHeader::UInt64);
  const std::uint64_t file_end = reader.fileSize();
  check (chunks_begin + sizeof (TableHeader) <= file_end && chunk_size > 0);
  std::uint64_t table_offset = reader.readAt<LasHeader::UInt64> (header.points_offset);
  if (table_offset == table_offset_at_end)
    table_offset =
        reader.readAt<LasHeader::UInt64> (file_end - sizeof (LasHeader::UInt64));
  check (chunks_begin <= table_offset &&
         table_offset <= file_end - sizeof (TableHeader));
  const auto table = reader.readAt<TableHeader> (table_offset);
  // The first point of each chunk is not compressed, so a chunk has a record or more.
  check (table.version == 0 && table.chunk_count > 0 &&
         table.chunk_count <= (file_end - chunks_begin) / header.record_length);
  check (chunk_size == sizes_differ ||
         table.chunk_count == (las.size() + chunk_size - 1) / chunk_size);
}

} // namespace

void
decompressLaz (const std::string& file, std::ostream& stream)
{
  LasFile las (file);
  const LasHeader& header = las.header;
  las.checkCount();
  std::string front = las.bytes (0, header.points_offset);
  LasHeader plain_header = header;
  plain_header.format_bits = header.pointFormat();
  if (las.laszip) {
    checkCompression (las);
    --plain_header.vlr_count;
    front.erase (las.laszip->begin, las.laszip->end - las.laszip->begin);
  }
  // No field of the header tells where compressed points end: at what follows them.
  std::uint64_t points_end = las.reader.fileSize();
  for (const std::uint64_t next : {header.waveform_offset, header.evlr_offset})
    if (next > header.points_offset)
      points_end = std::min (points_end, next);
  const std::uint64_t plain_size = las.size() * header.record_length; // [bytes]
  las.replaceHeader (plain_header, points_end, front.size() + plain_size, front);
  stream << front;
  convertPoints (las, Conversion::Decompress, stream);
  las.copyFrom (points_end, stream);
}

void
compressLas (const std::string& file, std::ostream& stream)
{
  LasFile las (file);
  LasHeader compressed_header = las.header;
  compressed_header.format_bits = compressed_header.pointFormat() | compressed_bit;
  ++compressed_header.vlr_count;
  std::string front = las.bytes (0, las.header.points_offset);
  front.insert (las.vlrs_end, newLaszipVlr (las));
  stream << front;
  convertPoints (las, Conversion::Compress, stream);
  // The end of the compressed points is known only now: so the header is written again.
  const auto compressed_end =
      static_cast<std::uint64_t> (std::streamoff (stream.tellp()));
  const std::uint64_t plain_end = las.header.pointsEnd();
  las.copyFrom (plain_end, stream);
  las.replaceHeader (compressed_header, plain_end, compressed_end, front);
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
  // saveLasWith refuses a .laz before it calls this: only tests get here.
  decompressLaz (file, stream); // throws
}

bool
hasLaszip ()
{
  return false;
}

#endif

} // namespace pcl_ops::apps

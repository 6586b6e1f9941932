// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laz_file.h"

#include "las_header.h"
#include "output_file.h"
#include <cli/errors.h>
#ifdef PCL_OPS_WITH_LASZIP
#include <cli/program.h>
#include <laszip/laszip_api.h>
#endif

#include <algorithm>
#include <limits>

namespace pcl_ops::apps {

bool
isLazName (const std::string& file)
{
  return extensionOf (file) == ".laz";
}

bool
isLasName (const std::string& file)
{
  return hasExtension (file, {".las", ".laz"});
}

bool
hasLaszip ()
{
#ifdef PCL_OPS_WITH_LASZIP
  return true;
#else
  return false;
#endif
}

bool
isCompressedLas (const std::string& file)
{
  const LasFrame las (file);
  return las.header.says_laz || las.laszip;
}

#ifdef PCL_OPS_WITH_LASZIP

namespace {

constexpr std::uint8_t compressed = 0x80;
/** \brief How LASzip calls points that are not in chunks. */
constexpr char in_one_chunk = 1;

[[noreturn]] void
failDamagedPoints (const std::string& file)
{
  throw WorkError (file,
                   "is truncated or damaged: its points cannot be decompressed; copy "
                   "or write it again");
}

/** \brief A reader or writer. */
class Laszip {
public:
  explicit Laszip (const std::string& file) : file_ (file)
  {
    if (laszip_create (&handle_) != 0)
      throw std::bad_alloc();
  }
  Laszip (const Laszip&) = delete;
  Laszip&
  operator= (const Laszip&) = delete;
  ~Laszip()
  {
    if (handle_ == nullptr)
      return;
    // Whichever is open; it does not go by itself.
    laszip_close_reader (handle_);
    laszip_close_writer (handle_);
    laszip_destroy (handle_);
  }

  void
  check (laszip_I32 failed) const
  {
    if (failed == 0)
      return;
    laszip_CHAR* reason = nullptr;
    laszip_get_error (handle_, &reason);
    // So it says that there is no memory.
    if (reason != nullptr && std::string (reason).rfind ("internal error", 0) == 0)
      throw std::bad_alloc();
    failDamagedPoints (file_);
  }

  /** \brief Leaves a writer that failed as it is: LASzip would crash. */
  void
  abandon ()
  {
    handle_ = nullptr;
  }

  laszip_POINTER
  handle () const
  {
    return handle_;
  }

  laszip_point*
  point () const
  {
    laszip_point* point = nullptr;
    check (laszip_get_point_pointer (handle_, &point));
    return point;
  }

  void
  setForm (const LasHeader& header) const
  {
    check (
        laszip_set_point_type_and_size (handle_, header.format, header.record_length));
  }

private:
  std::string file_;
  laszip_POINTER handle_ = nullptr;
};

/** \throws WorkError if LASzip cannot compress such points */
std::string
laszipVlr (const LasFrame& las)
{
  const Laszip writer (las.file);
  writer.setForm (las.header);
  laszip_U8* bytes = nullptr;
  laszip_U32 size = 0;
  writer.check (laszip_create_laszip_vlr (writer.handle(), &bytes, &size));
  return {reinterpret_cast<const char*> (bytes), size};
}

enum class PointsAs { Plain, Compressed };

/** \throws WorkError if the points are damaged, and Interrupted */
void
convertPoints (const LasFrame& las, PointsAs form, std::ostream& stream)
{
  const std::string& file = las.file;
  constexpr std::uint64_t block = 1U << 14U;
  const Laszip reader (file);
  Laszip writer (file);
  laszip_BOOL is_compressed = 0;
  reader.check (laszip_open_reader (reader.handle(), file.c_str(), &is_compressed));
  writer.setForm (las.header);
  writer.check (laszip_open_writer_stream (
      writer.handle(), stream, form == PointsAs::Compressed ? 1 : 0, 1));
  const laszip_point* const from = reader.point();
  for (std::uint64_t i = 0; i < las.header.points; ++i) {
    if (i % block == 0)
      stopIfInterrupted();
    reader.check (laszip_read_point (reader.handle()));
    writer.check (laszip_set_point (writer.handle(), from));
    const laszip_I32 failed = laszip_write_point (writer.handle());
    if (!stream)
      return writer.abandon(); // whose stream it is finds out
    writer.check (failed);
  }
  if (laszip_close_writer (writer.handle()) != 0)
    writer.abandon();
  if (stream && writer.handle() == nullptr)
    throw std::bad_alloc();
}

/** \brief Where the points end: no field of a header says it. */
std::uint64_t
endOfCompressed (const LasFrame& las)
{
  std::uint64_t end = las.reader.fileSize();
  for (const std::uint64_t next : {las.header.waveform_offset, las.header.evlr_offset})
    if (next > las.header.points_offset)
      end = std::min (end, next);
  return end;
}

/** \brief The LASzip VLR's content.
 * \throws WorkError if it does not describe such points: LASzip would crash */
std::string
checkedDescription (LasFrame& las, const LasVlr& laszip)
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
  if (content[0] == in_one_chunk && las.header.format <= newest_in_one_chunk)
    take (0, 1);
  if (content != expected)
    failDamagedPoints (las.file);
  return content;
}

/** \brief Refuses points that LASzip would crash at: their description is wrong, or the
 * table of their chunks is elsewhere or has another length. On chunks see M. Isenburg,
 * LASzip, Photogrammetric Engineering and Remote Sensing 79 (2), 2013. */
void
checkCompression (LasFrame& las)
{
  constexpr std::size_t chunk_size_at = 12;
  constexpr std::uint64_t head = 8;
  constexpr std::uint32_t of_any_size = std::numeric_limits<std::uint32_t>::max();
  constexpr std::uint64_t at_end = std::numeric_limits<std::uint64_t>::max();
  const std::string content = checkedDescription (las, *las.laszip);
  if (content[0] == in_one_chunk)
    return;
  const auto size = fromLittleEndian<std::uint32_t> (&content[chunk_size_at]);
  const auto check = [&] (bool is_good) {
    if (!is_good)
      failDamagedPoints (las.file);
  };
  const auto head_at = [&] (std::uint64_t place) {
    return las.bytes (place, place + head);
  };
  const LasHeader& header = las.header;
  const std::uint64_t begin = header.points_offset + head, end = las.reader.fileSize();
  check (begin + head <= end && size > 0);
  auto table = fromLittleEndian<std::uint64_t> (head_at (header.points_offset).data());
  if (table == at_end)
    table = fromLittleEndian<std::uint64_t> (head_at (end - head).data());
  check (begin <= table && table <= end - head);
  const std::string table_head = head_at (table);
  const auto version = fromLittleEndian<std::uint32_t> (&table_head[0]);
  const std::uint64_t chunks = fromLittleEndian<std::uint32_t> (&table_head[4]);
  // Each begins with a point that is not compressed.
  check (version == 0 && chunks > 0 && chunks <= (end - begin) / header.record_length);
  check (size == of_any_size || chunks == (header.points + size - 1) / size);
}

} // namespace

void
decompressLaz (const std::string& file, std::ostream& stream)
{
  LasFrame las (file);
  const LasHeader& header = las.header;
  las.checkCount();
  std::string front = las.bytes (0, header.points_offset);
  setNumber (front, las_field::format, header.format);
  if (las.laszip) {
    checkCompression (las);
    setNumber (front, las_field::vlr_count, header.vlr_count - 1);
    front.erase (las.laszip->begin, las.laszip->end - las.laszip->begin);
  }
  const std::uint64_t end = endOfCompressed (las);
  las.relocate (end, static_cast<std::int64_t> (header.pointsEnd() - end), front);
  stream << front;
  convertPoints (las, PointsAs::Plain, stream);
  las.copyRest (end, stream);
}

void
compressLas (const std::string& file, std::ostream& stream)
{
  LasFrame las (file);
  const LasHeader& header = las.header;
  std::string front = las.bytes (0, header.points_offset);
  setNumber (front, las_field::format, std::uint8_t (header.format | compressed));
  setNumber (front, las_field::vlr_count, header.vlr_count + 1);
  front.insert (las.vlrs_end, laszipVlr (las));
  stream << front;
  convertPoints (las, PointsAs::Compressed, stream);
  const auto end = static_cast<std::int64_t> (std::streamoff (stream.tellp()));
  las.copyRest (header.pointsEnd(), stream);
  // How much shorter the points are is known only now.
  const auto size = static_cast<std::int64_t> (front.size());
  const auto plain = static_cast<std::int64_t> (header.points * header.record_length);
  las.relocate (header.pointsEnd(), end - size - plain, front);
  stream.seekp (0);
  stream << front;
  stream.seekp (0, std::ios::end);
}

#else

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

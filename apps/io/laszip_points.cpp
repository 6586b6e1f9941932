// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laszip_points.h"

#include <cli/errors.h>
#include <cli/program.h>
#include <laszip/laszip_api.h>

#include <new>
#include <ostream>

namespace pcl_ops::apps {

void
failDamagedPoints (const std::string& file)
{
  throw WorkError (file,
                   "is truncated or damaged: its points cannot be decompressed; copy "
                   "or write it again");
}

namespace {

/** \brief One reader or writer of LASzip. */
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

  /** \param[in] failed what its functions return */
  void
  check (laszip_I32 failed) const
  {
    if (failed == 0)
      return;
    laszip_CHAR* reason = nullptr;
    laszip_get_error (handle_, &reason);
    // So it calls what it catches and did not throw: that there is no memory.
    if (reason != nullptr && std::string (reason).rfind ("internal error", 0) == 0)
      throw std::bad_alloc();
    failDamagedPoints (file_);
  }

  /** \brief Leaves a writer as it is that could not write: LASzip crashes where it is
   * to end what failed. */
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

} // namespace

std::string
laszipVlr (const std::string& file, const LasHeader& header)
{
  const Laszip writer (file);
  writer.setForm (header);
  laszip_U8* bytes = nullptr;
  laszip_U32 size = 0;
  writer.check (laszip_create_laszip_vlr (writer.handle(), &bytes, &size));
  return {reinterpret_cast<const char*> (bytes), size};
}

void
convertPoints (const std::string& file,
               const LasHeader& header,
               PointsAs form,
               std::ostream& stream)
{
  constexpr std::uint64_t block = 1U << 14U;
  const Laszip reader (file);
  Laszip writer (file);
  laszip_BOOL is_compressed = 0;
  reader.check (laszip_open_reader (reader.handle(), file.c_str(), &is_compressed));
  writer.setForm (header);
  writer.check (laszip_open_writer_stream (
      writer.handle(), stream, form == PointsAs::Compressed ? 1 : 0, 1));
  const laszip_point* const from = reader.point();
  for (std::uint64_t i = 0; i < header.points; ++i) {
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

} // namespace pcl_ops::apps

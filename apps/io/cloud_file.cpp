// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_file.h"

#include "cloud_fields.h"
#include "inputs.h"
#include "las_file.h"
#include "laz_file.h"
#include "output_file.h"
#include "pcd_file.h"
#include "ply_reader.h"
#include "ply_writer.h"
#include "text_file.h"
#include <cli/errors.h>
#include <cli/interruption.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

namespace pcl_ops::apps {

namespace {

[[noreturn]] void
failGzip (const std::string& file)
{
  throw WorkError (file, "is compressed (gzip); decompress it, e.g. by gunzip");
}

/** \brief Finds it by its first bytes, whatever the extension. */
void
refuseGzip (const std::string& file)
{
  std::ifstream stream (file, std::ios::binary);
  if (stream.get() == 0x1f && stream.get() == 0x8b)
    failGzip (file);
}

void
makePoseValid (FileCloud& cloud)
{
  if (!cloud.origin.head<3>().allFinite())
    cloud.origin.setZero();
  const float norm = cloud.orientation.norm();
  if (std::isfinite (norm) && norm > 0.0f)
    cloud.orientation.normalize();
  else
    cloud.orientation.setIdentity();
}

/** \brief Fills the buffer as far as the input reaches. \return bytes read */
std::size_t
readInput (std::vector<char>& buffer)
{
  std::size_t filled = 0;
  while (filled < buffer.size()) {
    const ssize_t count =
        ::read (STDIN_FILENO, buffer.data() + filled, buffer.size() - filled);
    stopIfInterrupted();
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      throw WorkError (standard_input,
                       std::string ("cannot be read (") + std::strerror (errno) +
                           "); pipe a PCD into the program");
    if (count == 0)
      break;
    filled += static_cast<std::size_t> (count);
  }
  return filled;
}

constexpr std::size_t start_length = 64;

/** \param[in] start the first bytes of a cloud */
std::string
extensionOfContent (const std::string& start)
{
  const auto begins_with = [&] (const std::string& text) {
    return start.compare (0, text.size(), text) == 0;
  };
  const std::string utf8_mark = "\xef\xbb\xbf";
  if (begins_with (utf8_mark))
    return extensionOfContent (start.substr (utf8_mark.size()));
  if (begins_with ("LASF"))
    return ".las";
  if (begins_with ("ply"))
    return ".ply";
  // A PCD begins with a word or a comment, which a text may, too.
  const std::size_t first = start.find_first_not_of (" \t\r\n");
  const bool is_number =
      first != std::string::npos &&
      std::string ("+-.0123456789").find (start[first]) != std::string::npos;
  return is_number || begins_with ("//") ? ".xyz" : ".pcd";
}

/** \brief Points of a cloud from \p first on, with the fields that are set for them. */
FileCloud
partOf (const FileCloud& cloud,
        std::size_t first,
        std::size_t count,
        const SetFields& set_fields)
{
  FileCloud part{{}, cloud.origin, cloud.orientation};
  part.points.fields = cloud.points.fields;
  part.points.point_step = cloud.points.point_step;
  part.points.width = static_cast<pcl::uindex_t> (count);
  part.points.height = 1;
  const std::uint8_t* const begin =
      cloud.points.data.data() + first * cloud.points.point_step;
  part.points.data.assign (begin, begin + count * cloud.points.point_step);
  if (set_fields)
    set_fields (part, first);
  return part;
}

} // namespace

bool
isCloudFile (const std::string& file)
{
  const std::string extension = extensionOf (file);
  return extension == ".pcd" || extension == ".ply" || extension == ".las" ||
         (extension == ".laz" && hasLaszip()) || extension == ".xyz" ||
         extension == ".pts";
}

bool
hasCloudExtension (const std::string& file)
{
  return isCloudFile (file) || isTextFile (file) || isLasName (file);
}

FileCloud
loadCloud (const std::string& file)
{
  const std::string extension = extensionOf (file);
  if (extension == ".gz")
    failGzip (file);
  if (!hasCloudExtension (file))
    throw UsageError (
        file, std::string ("has an unknown extension; give ") + cloud_file_kinds);
  checkReadable (file, cloud_file_kinds);
  refuseGzip (file);
  FileCloud cloud;
  if (extension == ".pcd")
    cloud = readPcd (file);
  else if (extension == ".ply")
    cloud = readPly (file);
  else if (isTextFile (file))
    cloud.points = readTextCloud (file);
  else {
    cloud.las = openLas (file);
    cloud.points = cloud.las->readPoints();
  }
  for (const char* axis : {"x", "y", "z"})
    if (!hasField (cloud, axis))
      throw WorkError (file,
                       std::string ("has no field ") + axis +
                           "; give a cloud with x, y and z");
  makePoseValid (cloud);
  cloud.is_survey = extension != ".pcd" && extension != ".ply";
  return cloud;
}

std::shared_ptr<LasFile>
openLas (const std::string& file)
{
  checkReadable (file, cloud_file_kinds);
  if (!isCompressedLas (file))
    return std::make_shared<LasFile> (file);
  const Spool las (".las", file);
  las.fill ([&] (std::ostream& stream) { decompressLaz (file, stream); });
  try {
    return std::make_shared<LasFile> (las.name());
  }
  catch (const WorkError& error) {
    throw WorkError (file, error.problem);
  }
}

void
saveCloud (const std::string& file, const FileCloud& cloud, const SetFields& set_fields)
{
  constexpr std::size_t block = 1U << 14U;
  const bool is_ply = extensionOf (file) == ".ply";
  writeFile (file, [&] (std::ostream& stream) {
    FileCloud header = partOf (cloud, 0, 0, set_fields);
    header.points.width = cloud.points.width;
    header.points.height = cloud.points.height;
    stream << (is_ply ? plyHeader (header.points) : pcdHeader (header));
    for (std::size_t i = 0; i < cloud.size() && stream; i += block) {
      const std::size_t count = std::min (block, cloud.size() - i);
      const FileCloud part = partOf (cloud, i, count, set_fields);
      if (is_ply)
        stream << plyVertices (part.points);
      else
        stream.write (reinterpret_cast<const char*> (part.points.data.data()),
                      static_cast<std::streamsize> (part.points.data.size()));
    }
  });
}

FileCloud
loadStandardInput ()
{
  constexpr std::size_t buffer_size = 1U << 20U;
  if (::isatty (STDIN_FILENO) == 1)
    throw UsageError (standard_input, "is the terminal; pipe a PCD into the program");
  std::vector<char> buffer (buffer_size);
  std::size_t count = readInput (buffer);
  const Spool spool (
      extensionOfContent (std::string (buffer.data(), std::min (count, start_length))),
      standard_input);
  spool.fill ([&] (std::ostream& stream) {
    for (; count > 0 && stream; count = readInput (buffer))
      stream.write (buffer.data(), static_cast<std::streamsize> (count));
  });
  try {
    return loadCloud (spool.name());
  }
  catch (const WorkError& error) {
    throw WorkError (standard_input, error.problem);
  }
}

} // namespace pcl_ops::apps

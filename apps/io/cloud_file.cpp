// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_file.h"

#include <pcl/common/io.h>

#include "cloud_formats.h"
#include "header_reader.h"
#include "inputs.h"
#include "las_file.h"
#include "output_file.h"
#include <cli/errors.h>
#include <cli/program.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace pcl_ops::apps {

namespace {

FileCloud
readLas (const std::string& file)
{
  FileCloud cloud;
  cloud.las = openLas (file);
  cloud.points = cloud.las->readPoints();
  return cloud;
}

[[noreturn]] FileCloud
refuseE57 (const std::string& file)
{
  throw WorkError (file,
                   "is E57; convert it, e.g. by pdal translate scan.e57 scan.las, or "
                   "read it in Python by pye57 and give the points to pcl_ops.segment");
}

[[noreturn]] FileCloud
refuseRecap (const std::string& file)
{
  throw WorkError (file,
                   "is a project of ReCap, which only Autodesk's programs read; export "
                   "it there as .pts");
}

[[noreturn]] FileCloud
refuseIfc (const std::string& file)
{
  throw WorkError (file,
                   "is IFC, a model without points; make a mesh of it, e.g. by "
                   "IfcConvert model.ifc model.obj, and sample points on that, e.g. by "
                   "CloudCompare");
}

struct Format {
  const char* extension;
  FileCloud (*read) (const std::string& file);
  /** \brief The result of \ref isCloudFile. */
  bool is_cloud_file;
  /** \brief The value of FileCloud::is_survey. */
  bool is_survey;
  /** \brief Whether messages name the extension: every build reads it. */
  bool is_named = true;
};

const std::vector<Format>&
allFormats ()
{
  static const std::vector<Format> formats = {
      {".pcd", readPcd, true, false},
      {".ply", readPly, true, false},
      {".las", readLas, true, true},
      {".laz", readLas, hasLaszip(), true, false},
      {".ptx", readPtx, true, false},
      {".xyz", readTextCloud, true, true},
      {".xyzrgb", readTextCloud, true, true},
      {".pts", readTextCloud, true, true},
      {".asc", readTextCloud, true, true},
      {".txt", readTextCloud, false, true},
      {".csv", readTextCloud, false, true},
      {".bin", readKitti, true, false},
      {".npy", readNpy, false, false},
      {".off", readOff, false, true},
      {".obj", readObj, false, true},
      {".e57", refuseE57, false, false, false},
      {".rcp", refuseRecap, false, false, false},
      {".rcs", refuseRecap, false, false, false},
      {".ifc", refuseIfc, false, false, false}};
  return formats;
}

/** \return nullptr if no format has the extension */
const Format*
formatOf (const std::string& file)
{
  const std::string extension = extensionOf (file);
  for (const Format& format : allFormats())
    if (extension == format.extension)
      return &format;
  return nullptr;
}

/** \brief Lists the extensions of the wanted formats: ".a, .b or .c". */
std::string
listOf (const std::function<bool (const Format&)>& is_wanted)
{
  std::string list;
  std::string last;
  for (const Format& format : allFormats())
    if (is_wanted (format)) {
      list += (list.empty() || last.empty() ? "" : ", ") + last;
      last = format.extension;
    }
  return list + " or " + last;
}

/** \brief Reads the standard input until the buffer is full or the input ends.
 * \return number of bytes read */
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

/** \brief Returns the extension of a format that is recognized by its first bytes;
 * empty for other formats. */
std::string
extensionOfBinary (const std::string& start)
{
  const auto begins_with = [&start] (const char* mark) {
    return start.rfind (mark, 0) == 0;
  };
  if (begins_with ("LASF"))
    return ".las";
  if (begins_with ("\x93NUMPY"))
    return ".npy";
  if (begins_with ("ASTM-E57"))
    return ".e57";
  if (begins_with ("ISO-10303-21"))
    return ".ifc";
  return "";
}

/** \brief Returns the extension of a text format, or of PCD, by the first word that is
 * no number and in no comment. */
std::string
extensionOfWord (const std::string& word)
{
  if (word == "ply")
    return ".ply";
  if (word.find ("OFF") < 3)
    return ".off";
  const auto first = static_cast<unsigned char> (word[0]);
  return std::iscntrl (first) == 0 && !isPcdKey (word) ? ".xyz" : ".pcd";
}

/** \brief Returns the extension of the format of a cloud, by its first bytes. KITTI's
 * .bin and .obj cannot be recognized.
 * \param[in] start of the cloud, as long as the longest header */
std::string
extensionOfContent (const std::string& start)
{
  const std::string of_binary = extensionOfBinary (start);
  if (!of_binary.empty())
    return of_binary;
  std::istringstream lines (start);
  std::string line;
  std::vector<std::string_view> words;
  bool is_behind_number = false;
  while (std::getline (lines, line)) {
    splitWords (line, ' ', words);
    if (words.empty() || words[0][0] == '#')
      continue;
    const std::string word (words[0]);
    const auto first = static_cast<unsigned char> (word[0]);
    const bool is_number = words.size() == 1 && std::isdigit (first) != 0;
    if (!is_number)
      return extensionOfWord (word);
    if (is_behind_number) // a line with the columns, one with the rows
      return ".ptx";
    is_behind_number = true;
  }
  return is_behind_number ? ".xyz" : ".pcd";
}

pcl::PCLPointField
fieldOf (const std::string& name,
         pcl::uindex_t offset,
         std::uint8_t datatype,
         pcl::uindex_t count)
{
  pcl::PCLPointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = datatype;
  field.count = count;
  return field;
}

/** \brief Renames fields X, Y and Z, as PDAL writes them, to x, y and z. */
void
nameCoordinates (pcl::PCLPointCloud2& points)
{
  const std::pair<const char*, const char*> names[] = {
      {"x", "X"}, {"y", "Y"}, {"z", "Z"}};
  for (const auto& [name, capital] : names)
    if (pcl::getFieldIndex (points, name) < 0)
      for (pcl::PCLPointField& field : points.fields)
        if (field.name == capital)
          field.name = name;
}

FileCloud
partOf (const FileCloud& cloud,
        std::size_t first,
        std::size_t count,
        const SetFields& set_fields)
{
  FileCloud part = emptyLike (cloud, count);
  const std::uint8_t* const begin =
      cloud.points.data.data() + first * cloud.points.point_step;
  part.points.data.assign (begin, begin + count * cloud.points.point_step);
  if (set_fields)
    set_fields (part, first);
  return part;
}

} // namespace

std::string
cloudFileKinds ()
{
  return "a " + listOf ([] (const Format& format) { return format.is_named; }) +
         " file";
}

std::string
folderExtensions ()
{
  return listOf (
      [] (const Format& format) { return format.is_cloud_file && format.is_named; });
}

bool
isCloudFile (const std::string& file)
{
  const Format* const format = formatOf (file);
  return format != nullptr && format->is_cloud_file;
}

bool
hasCloudExtension (const std::string& file)
{
  return formatOf (file) != nullptr;
}

FileCloud
loadCloud (const std::string& file)
{
  const WorkError gzip (file, "is compressed (gzip); decompress it, e.g. by gunzip");
  if (extensionOf (file) == ".gz")
    throw gzip;
  const Format* const format = formatOf (file);
  if (format == nullptr)
    throw UsageError (file, "has an unknown extension; give " + cloudFileKinds());
  checkReadable (file, cloudFileKinds());
  std::ifstream stream (file, std::ios::binary);
  if (stream.get() == 0x1f && stream.get() == 0x8b)
    throw gzip;
  FileCloud cloud = format->read (file);
  nameCoordinates (cloud.points);
  for (const char* axis : {"x", "y", "z"})
    if (!hasField (cloud, axis))
      throw WorkError (file,
                       std::string ("has no field ") + axis +
                           "; give a cloud with x, y and z");
  cloud.points.row_step = cloud.points.point_step * cloud.points.width;
  if (!cloud.origin.allFinite())
    cloud.origin.setZero();
  constexpr double rounding =
      1e-6; // a quaternion written in single precision stays unchanged
  const double norm = cloud.orientation.norm();
  if (!std::isfinite (norm) || norm <= 0.0)
    cloud.orientation.setIdentity();
  else if (std::abs (norm - 1.0) > rounding)
    cloud.orientation.normalize();
  cloud.is_survey = format->is_survey;
  return cloud;
}

FileCloud
emptyLike (const FileCloud& cloud, std::size_t size)
{
  FileCloud empty{{}, cloud.origin, cloud.orientation};
  empty.points.fields = cloud.points.fields;
  empty.points.point_step = cloud.points.point_step;
  empty.points.width = static_cast<pcl::uindex_t> (size);
  empty.points.height = 1;
  return empty;
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
  const Spool spool (extensionOfContent (std::string (buffer.data(), count)),
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

void
addField (const std::string& name,
          std::uint8_t datatype,
          pcl::PCLPointCloud2& points,
          pcl::uindex_t count)
{
  points.fields.push_back (fieldOf (name, points.point_step, datatype, count));
  points.point_step += static_cast<pcl::uindex_t> (count * numberType (datatype).size);
}

bool
hasField (const FileCloud& cloud, const std::string& name)
{
  return pcl::getFieldIndex (cloud.points, name) >= 0;
}

void
setField (FileCloud& file_cloud,
          const std::string& name,
          std::uint8_t datatype,
          const void* values,
          const std::string& before)
{
  constexpr pcl::uindex_t size = 4;
  pcl::PCLPointCloud2& cloud = file_cloud.points;
  const int known = pcl::getFieldIndex (cloud, name);
  const int next = known < 0 ? pcl::getFieldIndex (cloud, before) : known;
  const std::size_t place =
      next < 0 ? cloud.fields.size() : static_cast<std::size_t> (next);
  const auto start_of = [&] (std::size_t field) {
    return field < cloud.fields.size() ? cloud.fields[field].offset : cloud.point_step;
  };
  const pcl::uindex_t begin = start_of (place);
  const pcl::uindex_t end = known < 0 ? begin : start_of (place + 1);
  const pcl::uindex_t step = cloud.point_step - (end - begin) + size;

  std::vector<std::uint8_t> bytes (file_cloud.size() * step);
  std::uint8_t* out = bytes.data();
  for (std::size_t i = 0; i < file_cloud.size(); ++i) {
    const std::uint8_t* const point = cloud.data.data() + i * cloud.point_step;
    out = std::copy_n (point, begin, out);
    out = std::copy_n (static_cast<const std::uint8_t*> (values) + i * size, size, out);
    out = std::copy (point + end, point + cloud.point_step, out);
  }
  if (known < 0)
    cloud.fields.insert (cloud.fields.begin() + static_cast<std::ptrdiff_t> (place),
                         pcl::PCLPointField());
  cloud.fields[place] = fieldOf (name, begin, datatype, 1);
  for (std::size_t i = place + 1; i < cloud.fields.size(); ++i)
    cloud.fields[i].offset = begin + size + (cloud.fields[i].offset - end);
  cloud.data = std::move (bytes);
  cloud.point_step = step;
  cloud.row_step = step * cloud.width;
}

} // namespace pcl_ops::apps

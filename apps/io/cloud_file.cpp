// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_file.h"

#include <pcl/common/io.h>

#include "cloud_formats.h"
#include "file_reader.h"
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

/** \brief Whether a file of a format is taken for a cloud where a folder is given (\ref
 * isCloudFile). */
enum class InFolder { Taken, LeftOut };

/** \brief What clouds of a format come from: a survey has no pose
 * (FileCloud::is_survey). Has no meaning for formats that are refused. */
enum class Source { Sensor, Survey };

/** \brief Whether messages name the extension of a format. They name those that every
 * build can read. */
enum class InMessages { Named, LeftOut };

struct Format {
  /** \brief In lower case, with its dot. */
  const char* extension;
  FileCloud (*read) (const std::string& file);
  InFolder in_folder;
  Source source = Source::Sensor;
  InMessages in_messages = InMessages::Named;

  bool
  isNamed () const
  {
    return in_messages == InMessages::Named;
  }
};

const std::vector<Format>&
allFormats ()
{
  constexpr InFolder taken = InFolder::Taken, left_out = InFolder::LeftOut;
  constexpr Source sensor = Source::Sensor, survey = Source::Survey;
  constexpr InMessages unnamed = InMessages::LeftOut;
  const InFolder taken_with_laszip = hasLaszip() ? taken : left_out;
  static const std::vector<Format> formats = {
      {".pcd", readPcd, taken, sensor},
      {".ply", readPly, taken, sensor},
      {".las", readLas, taken, survey},
      {".laz", readLas, taken_with_laszip, survey, unnamed},
      {".ptx", readPtx, taken, sensor},
      {".xyz", readTextCloud, taken, survey},
      {".xyzrgb", readTextCloud, taken, survey},
      {".pts", readTextCloud, taken, survey},
      {".asc", readTextCloud, taken, survey},
      {".txt", readTextCloud, left_out, survey},
      {".csv", readTextCloud, left_out, survey},
      {".bin", readKitti, taken, sensor},
      {".npy", readNpy, left_out, sensor},
      {".off", readOff, left_out, survey},
      {".obj", readObj, left_out, survey},
      {".e57", refuseE57, left_out, sensor, unnamed},
      {".rcp", refuseRecap, left_out, sensor, unnamed},
      {".rcs", refuseRecap, left_out, sensor, unnamed},
      {".ifc", refuseIfc, left_out, sensor, unnamed}};
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

/** \brief Returns the extensions of the wanted formats as text, ".a, .b or .c". At
 * least two formats must be wanted. */
std::string
listOf (const std::function<bool (const Format&)>& is_wanted)
{
  std::string all_but_last;
  std::string last;
  for (const Format& format : allFormats())
    if (is_wanted (format)) { // so the wanted format before is not the last one
      all_but_last += (all_but_last.empty() || last.empty() ? "" : ", ") + last;
      last = format.extension;
    }
  return all_but_last + " or " + last;
}

/** \brief Reads the standard input until the buffer is full or the input ends.
 * \return number of bytes read */
std::size_t
readStandardInput (std::vector<char>& buffer)
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

/** \brief Returns the extension of the format whose files begin with a signature, if
 * this is one of them; else an empty string.
 * \param[in] start the first bytes of the file */
std::string
extensionOfSignature (const std::string& start)
{
  const auto begins_with = [&start] (const char* signature) {
    return start.rfind (signature, 0) == 0;
  };
  if (begins_with ("LASF"))
    return ".las";
  if (begins_with ("\x93NUMPY"))
    return ".npy";
  if (begins_with ("ASTM-E57"))
    return ".e57";
  if (begins_with ("ISO-10303-21"))
    return ".ifc";
  if (begins_with ("\x1f\x8b"))
    return ".gz";
  return "";
}

/** \brief Whether a line is one with which an .obj may begin: names behind a keyword,
 * or a vertex, its normal or its texture as numbers behind a keyword. */
bool
isLineOfObj (const std::vector<std::string_view>& words)
{
  double number = 0.0;
  for (const char* keyword : {"mtllib", "usemtl", "o", "g", "s"})
    if (words[0] == keyword)
      return true;
  return words.size() > 2 &&
         (words[0] == "v" || words[0] == "vn" || words[0] == "vt") &&
         numberType (pcl::PCLPointField::FLOAT64)
             .parse (std::string (words[1]), &number);
}

/** \brief Returns the extension of a text format or of PCD.
 * \param[in] words of the first line that is neither empty, nor a comment, nor a single
 * number
 * \throws WorkError if the content of a pipe cannot be told */
std::string
extensionOfLine (const std::vector<std::string_view>& words)
{
  const std::string word (words[0]);
  constexpr std::size_t max_letters_before_off = 2; // COFF, NOFF, CNOFF
  if (word == "ply")
    return ".ply";
  if (word.find ("OFF") <= max_letters_before_off)
    return ".off";
  const bool is_text = std::none_of (word.begin(), word.end(), [] (char letter) {
    return std::iscntrl (static_cast<unsigned char> (letter)) != 0;
  });
  // As text the corners of triangles would become points.
  if (!is_text || isLineOfObj (words))
    throw WorkError (standard_input,
                     is_text ? "may be an .obj, which a pipe does not tell from text; "
                               "give the file"
                             : "begins as no format that a pipe tells; give the file");
  return isPcdKey (word) ? ".pcd" : ".xyz";
}

/** \brief Returns the extension of the format of a cloud in a pipe, by its first bytes.
 * \param[in] start the first bytes, at most 1 MiB (the longest header)
 * \throws WorkError for what may be an .obj, and for a .bin of KITTI */
std::string
extensionOfContent (const std::string& start)
{
  const std::string of_signature = extensionOfSignature (start);
  if (!of_signature.empty())
    return of_signature;
  std::istringstream lines (start);
  std::string line;
  std::vector<std::string_view> words;
  bool follows_single_number = false; // whether a line of one number was read
  while (std::getline (lines, line)) {
    splitWords (line, ' ', words);
    if (words.empty() || words[0][0] == '#')
      continue;
    const auto first = static_cast<unsigned char> (words[0][0]);
    const bool is_one_number = words.size() == 1 && std::isdigit (first) != 0;
    if (!is_one_number)
      return extensionOfLine (words);
    if (follows_single_number) // the numbers of columns and of rows begin a PTX
      return ".ptx";
    follows_single_number = true;
  }
  return follows_single_number ? ".xyz" : ".pcd";
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

/** \brief Renames fields X, Y and Z, as PDAL writes them, to x, y and z, where the file
 * does not have these. */
void
nameCoordinates (pcl::PCLPointCloud2& points)
{
  struct Axis {
    const char *name, *capital;
  };
  for (const auto& [name, capital] : {Axis{"x", "X"}, Axis{"y", "Y"}, Axis{"z", "Z"}})
    if (pcl::getFieldIndex (points, name) < 0)
      for (pcl::PCLPointField& field : points.fields)
        if (field.name == capital)
          field.name = name;
}

/** \brief Sets an invalid origin to zero and an invalid orientation to the identity,
 * and normalizes a valid one. */
void
repairPose (FileCloud& cloud)
{
  // A unit quaternion that was written in single precision stays unchanged: its numbers
  // are rounded by 6e-8 at most.
  constexpr double rounding = 1e-6; // of the length
  if (!cloud.origin.allFinite())
    cloud.origin.setZero();
  const double norm = cloud.orientation.norm();
  if (!std::isfinite (norm) || norm <= 0.0)
    cloud.orientation.setIdentity();
  else if (std::abs (norm - 1.0) > rounding)
    cloud.orientation.normalize();
}

/** \brief Returns a copy of \p count points of a cloud, the first one that with index
 * \p first, with the changes that \p set_fields makes. */
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

/** \brief Number of bytes of the field of \ref setField. */
constexpr pcl::uindex_t set_field_length = 4;

/** \brief Returns the data of a cloud in which each point has the next four bytes of
 * \p values in place of its bytes from the offset \p begin up to \p end. */
std::vector<std::uint8_t>
dataWithValues (const pcl::PCLPointCloud2& points,
                pcl::uindex_t begin,
                pcl::uindex_t end,
                const void* values)
{
  const std::size_t size = sizeOf (points);
  std::vector<std::uint8_t> data (
      size * (points.point_step - (end - begin) + set_field_length));
  std::uint8_t* out = data.data();
  const auto* value = static_cast<const std::uint8_t*> (values);
  for (std::size_t i = 0; i < size; ++i, value += set_field_length) {
    const std::uint8_t* const point = points.data.data() + i * points.point_step;
    out = std::copy_n (point, begin, out);
    out = std::copy_n (value, set_field_length, out);
    out = std::copy (point + end, point + points.point_step, out);
  }
  return data;
}

} // namespace

std::string
cloudFileKinds ()
{
  return "a " + listOf ([] (const Format& format) { return format.isNamed(); }) +
         " file";
}

std::string
folderExtensions ()
{
  return listOf ([] (const Format& format) {
    return format.in_folder == InFolder::Taken && format.isNamed();
  });
}

bool
isCloudFile (const std::string& file)
{
  const Format* const format = formatOf (file);
  return format != nullptr && format->in_folder == InFolder::Taken;
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
  constexpr int gzip_mark[] = {0x1f, 0x8b};
  if (stream.get() == gzip_mark[0] && stream.get() == gzip_mark[1])
    throw gzip;
  FileCloud cloud = format->read (file);
  nameCoordinates (cloud.points);
  for (const char* coordinate : {"x", "y", "z"})
    if (!hasField (cloud, coordinate))
      throw WorkError (file,
                       std::string ("has no field ") + coordinate +
                           "; give a cloud with x, y and z");
  cloud.points.row_step = cloud.points.point_step * cloud.points.width;
  repairPose (cloud);
  cloud.is_survey = format->source == Source::Survey;
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
  // A block is small beside a large cloud, and its own copy of the fields small beside
  // its points; chosen by hand.
  constexpr std::size_t points_in_block = 1U << 14U;
  const bool is_ply = extensionOf (file) == ".ply";
  writeFile (file, [&] (std::ostream& stream) {
    FileCloud header = partOf (cloud, 0, 0, set_fields); // fields without points
    header.points.width = cloud.points.width;
    header.points.height = cloud.points.height;
    stream << (is_ply ? plyHeader (header.points) : pcdHeader (header));
    for (std::size_t first = 0; first < cloud.size() && stream;
         first += points_in_block) {
      const std::size_t count = std::min (points_in_block, cloud.size() - first);
      const FileCloud part = partOf (cloud, first, count, set_fields);
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
  constexpr std::size_t buffer_size = 1U << 20U; // [bytes], as the longest header
  if (::isatty (STDIN_FILENO) == 1)
    throw UsageError (standard_input, "is the terminal; pipe a PCD into the program");
  std::vector<char> buffer (buffer_size);
  std::size_t filled = readStandardInput (buffer); // number of bytes in the buffer
  const TemporaryFile temporary (
      extensionOfContent (std::string (buffer.data(), filled)), standard_input);
  temporary.fill ([&] (std::ostream& stream) {
    for (; filled > 0 && stream; filled = readStandardInput (buffer))
      stream.write (buffer.data(), static_cast<std::streamsize> (filled));
  });
  try {
    return loadCloud (temporary.name());
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
setField (FileCloud& cloud,
          const std::string& name,
          std::uint8_t datatype,
          const void* values,
          const std::string& before)
{
  pcl::PCLPointCloud2& points = cloud.points;
  const int index_of_same_name = pcl::getFieldIndex (points, name);
  const bool is_new = index_of_same_name < 0;
  const int found_index =
      is_new ? pcl::getFieldIndex (points, before) : index_of_same_name;
  // The index of the field once it is set: the end if no field has either name.
  std::size_t index = points.fields.size();
  if (found_index >= 0)
    index = static_cast<std::size_t> (found_index);
  const auto offset_of = [&] (std::size_t i) {
    return i < points.fields.size() ? points.fields[i].offset : points.point_step;
  };
  // The field replaces the bytes of a point from begin up to end; none if it is new.
  const pcl::uindex_t begin = offset_of (index);
  const pcl::uindex_t end = is_new ? begin : offset_of (index + 1);
  points.data = dataWithValues (points, begin, end, values);
  if (is_new)
    points.fields.insert (points.fields.begin() + static_cast<std::ptrdiff_t> (index),
                          pcl::PCLPointField());
  points.fields[index] = fieldOf (name, begin, datatype, 1);
  for (std::size_t i = index + 1; i < points.fields.size(); ++i)
    points.fields[i].offset =
        begin + set_field_length + (points.fields[i].offset - end);
  points.point_step = points.point_step - (end - begin) + set_field_length;
  points.row_step = points.point_step * points.width;
}

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/PCLPointField.h>
#include <pcl/types.h>

#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/endian/arithmetic.hpp>

#include "cloud_formats.h"
#include "file_reader.h"
#include "number_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

/** \brief Whether a number may be a coordinate [m]. Bytes of something else, read as a
 * number, mostly have a much larger or smaller magnitude. NaN is no coordinate. */
bool
canBeCoordinate (float number)
{
  constexpr float largest = 1e7f;   // [m], the largest northing of UTM
  constexpr float smallest = 1e-9f; // [m], far below what any sensor resolves
  const float magnitude = std::abs (number);
  return magnitude == 0.0f || (magnitude > smallest && magnitude < largest);
}

/** \brief Refuses a file in which most points have an impossible coordinate, as most
 * files called .bin that are no clouds. */
void
checkArePoints (const FileReader& reader, const FileCloud& cloud)
{
  std::size_t possible_points = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::array<float, 3> point{};
    std::memcpy (
        point.data(), &cloud.points.data[i * cloud.points.point_step], sizeof (point));
    possible_points +=
        std::all_of (point.begin(), point.end(), canBeCoordinate) ? 1 : 0;
  }
  if (2 * possible_points < cloud.size())
    reader.fail ("most of its numbers are no coordinates in meters");
}

/** \brief Puts number i into column i % columns, and returns the largest minus the
 * smallest mean absolute value of a column. The result is near 0 if every column mixes
 * x, y and z. */
double
differenceOfColumns (const std::vector<float>& numbers, std::size_t columns)
{
  std::vector<double> sums (columns), counts (columns), means (columns);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (std::isfinite (numbers[i])) {
      sums[i % columns] += std::abs (numbers[i]);
      counts[i % columns] += 1.0;
    }
  for (std::size_t i = 0; i < columns; ++i)
    means[i] = sums[i] / std::max (counts[i], 1.0);
  const auto [smallest, largest] = std::minmax_element (means.begin(), means.end());
  return *largest - *smallest;
}

/** \brief Refuses a file whose points seem to have only x, y and z, not the intensity:
 * then each of four columns mixes x, y and z, and the four columns are alike, but three
 * columns are not. */
void
refuseTriples (const FileReader& reader, const FileCloud& cloud)
{
  constexpr std::size_t min_points = 100; // means of fewer differ by chance
  // Of the difference of four columns to that of three; chosen by hand.
  constexpr double max_ratio = 0.3;
  std::vector<float> numbers (cloud.points.data.size() / sizeof (float));
  std::memcpy (numbers.data(), cloud.points.data.data(), cloud.points.data.size());
  if (cloud.size() >= min_points && cloud.points.fields.size() == 4 &&
      differenceOfColumns (numbers, 4) < max_ratio * differenceOfColumns (numbers, 3))
    reader.fail ("it seems to have three numbers for each point, not x, y, z and "
                 "intensity");
}

/** \brief What the header of a .npy says about its array. */
struct NpyHeader {
  /** \brief NumPy's name of the number type, e.g. <f4. */
  std::string type;
  /** \brief Whether the first index is the fastest (Fortran), not the last (C). */
  bool is_fortran = false;
  std::vector<std::uint64_t> shape;
};

/** \brief Reads the Python literal that describes the array, without its spaces. It
 * follows a signature of six bytes, the version in two bytes, and its length, in two
 * bytes in version 1, in four in versions 2 and 3. */
std::string
readNpyLiteral (FileReader& reader)
{
  constexpr std::size_t start_size = 8, version_offset = 6; // [bytes]
  // As the message says; that of an array of plain numbers has some hundred bytes.
  constexpr std::uint32_t max_length = 1U << 16U; // [bytes]
  std::string start (std::min<std::uint64_t> (start_size, reader.fileSize()), '\0');
  reader.read (start.data(), start.size());
  if (start.rfind ("\x93NUMPY", 0) != 0)
    reader.fail ("its first bytes are not \\x93NUMPY");
  boost::endian::little_uint32_t length = 0;
  const bool has_long_length = start.size() == start_size && start[version_offset] > 1;
  constexpr std::size_t long_size = 4, short_size = 2; // [bytes]
  reader.read (&length, has_long_length ? long_size : short_size);
  if (length > max_length)
    reader.fail ("its header is longer than 64 KiB");
  std::string text (length, '\0');
  reader.read (text.data(), length);
  boost::algorithm::erase_all (text, " ");
  return text;
}

NpyHeader
readNpyHeader (FileReader& reader)
{
  const std::string text = readNpyLiteral (reader);
  // Returns the value of a key up to the character `end`, without the first character
  // of the value: a quote, a bracket, or the T or F of a truth value.
  const auto value_of = [&] (const std::string& key, char end) {
    const std::string quoted_key = "'" + key + "':";
    const std::size_t key_begin = text.find (quoted_key);
    const std::size_t value_begin = key_begin + quoted_key.size() + 1;
    const std::size_t value_end =
        key_begin == std::string::npos ? key_begin : text.find (end, value_begin);
    if (value_end == std::string::npos)
      reader.fail ("its header has no " + key);
    return text.substr (value_begin, value_end - value_begin);
  };
  NpyHeader header;
  header.type = value_of ("descr", '\'');
  constexpr const char* true_without_t = "rue"; // of True
  header.is_fortran = value_of ("fortran_order", ',') == true_without_t;
  const std::string shape = value_of ("shape", ')');
  std::vector<std::string_view> words;
  splitWords (shape, ',', words);
  for (const std::string_view word : words)
    if (!word.empty()) // as behind the last comma of (N,)
      header.shape.push_back (reader.parseCount ("its shape", std::string (word)));
  return header;
}

/** \brief Returns the type with a name of NumPy: "<f4" is a little endian float of 4
 * bytes. Single bytes have no order: "|u1".
 * \return nullptr for a type that is big endian or that NumberType lacks */
const NumberType*
numpyType (const std::string& name)
{
  return findNumberType ([&] (const NumberType& type) {
    const char kind = type.kind == 'F' ? 'f' : type.kind == 'I' ? 'i' : 'u';
    const std::string kind_and_size = kind + std::to_string (type.size);
    return name == "<" + kind_and_size ||
           (type.size == 1 && name == "|" + kind_and_size);
  });
}

const NumberType&
supportedType (const std::string& file, const NpyHeader& header)
{
  const NumberType* const type = numpyType (header.type);
  if (type == nullptr)
    throw WorkError (file,
                     "has no plain numbers that are little endian; save "
                     "array.astype ('<f4')");
  return *type;
}

/** \brief Refuses an array with x, y and z along its first index, not its last. */
void
refuseTransposed (const std::string& file, const std::vector<std::uint64_t>& shape)
{
  // x, y, z; three numbers each for color and normal; intensity.
  constexpr std::uint64_t max_columns_of_points = 10;
  if (shape.back() <= max_columns_of_points)
    return;
  if (shape.size() == 2 && shape[0] <= max_columns_of_points)
    throw WorkError (file,
                     "has an array of shape (" + std::to_string (shape[0]) + ", " +
                         std::to_string (shape[1]) +
                         "), which are coordinates in rows; save array.T");
  if (shape.size() == 3 && shape[0] == 3)
    throw WorkError (file,
                     "has an array of shape (3, H, W), not (H, W, 3); save "
                     "numpy.moveaxis (array, 0, -1)");
}

/** \brief Declares a field for each column, and takes width and height from the
 * dimensions in front of the columns.
 * \throws WorkError unless the file has exactly the numbers of the shape */
void
declarePoints (const std::string& file,
               FileReader& reader,
               const NpyHeader& header,
               pcl::PCLPointCloud2& points)
{
  constexpr std::uint64_t max_points = std::numeric_limits<pcl::index_t>::max();
  const NumberType& type = supportedType (file, header);
  const std::size_t dimensions = header.shape.size();
  const std::uint64_t columns = header.shape.empty() ? 0 : header.shape.back();
  if (dimensions < 2 || dimensions > 3 || columns < 3 || columns > max_columns)
    throw WorkError (file,
                     "has an array of another shape than (N, 3) or (H, W, 3), or more "
                     "columns; save array.T or array.reshape (-1, 3)");
  refuseTransposed (file, header.shape);
  const std::uint64_t height = dimensions == 3 ? header.shape[0] : 1;
  const std::uint64_t width = header.shape[dimensions - 2];
  if (width * height == 0)
    reader.failEmpty();
  const std::uint64_t data_size = reader.bytesLeft();
  if (width * height > max_points || width * height * columns > data_size / type.size)
    reader.failTruncated();
  if (width * height * columns * type.size != data_size)
    reader.fail ("it has more numbers than its shape says");
  for (std::uint64_t i = 0; i < columns; ++i)
    addField (i < 3 ? std::string (1, "xyz"[i]) : "field_" + std::to_string (i + 1),
              type.id,
              points);
  points.width = static_cast<pcl::uindex_t> (width);
  points.height = static_cast<pcl::uindex_t> (height);
}

/** \brief Returns the data of points in the order of a cloud: point by point, and the
 * points row by row.
 * \param[in] points whose data are in Fortran order: x of all points, then y of all,
 * and so on, and for each of these the points column by column */
std::vector<std::uint8_t>
fromFortranOrder (const pcl::PCLPointCloud2& points)
{
  std::vector<std::uint8_t> data (points.data.size());
  const std::size_t size = sizeOf (points);
  const std::size_t height = points.height;
  const std::size_t number_size = points.point_step / points.fields.size();
  const std::uint8_t* from = points.data.data();
  for (std::size_t field = 0; field < points.fields.size(); ++field)
    for (std::size_t i = 0; i < size; ++i, from += number_size) {
      const std::size_t row = i % height, column = i / height;
      const std::size_t point = row * points.width + column;
      std::copy_n (
          from, number_size, &data[point * points.point_step + field * number_size]);
    }
  return data;
}

} // namespace

FileCloud
readKitti (const std::string& file)
{
  FileReader reader (file, "KITTI");
  FileCloud cloud;
  for (const char* name : {"x", "y", "z", "intensity"})
    addField (name, PCLPointField::FLOAT32, cloud.points);
  if (boost::algorithm::iends_with (file, ".pcd.bin"))
    addField ("ring", PCLPointField::FLOAT32, cloud.points);
  const std::uint64_t point_size = cloud.points.point_step; // [bytes]
  if (reader.fileSize() % point_size != 0)
    reader.fail ("its size is no multiple of the " + std::to_string (point_size) +
                 " bytes of a point");
  cloud.points.width = static_cast<pcl::uindex_t> (reader.parseCount (
      "its number of points", std::to_string (reader.fileSize() / point_size)));
  cloud.points.height = 1;
  cloud.points.data.resize (reader.fileSize());
  reader.read (cloud.points.data.data(), cloud.points.data.size());
  checkArePoints (reader, cloud);
  refuseTriples (reader, cloud);
  return cloud;
}

FileCloud
readNpy (const std::string& file)
{
  FileReader reader (file, "NumPy");
  FileCloud cloud;
  const NpyHeader header = readNpyHeader (reader);
  declarePoints (file, reader, header, cloud.points);
  cloud.points.data.resize (cloud.size() * cloud.points.point_step);
  reader.read (cloud.points.data.data(), cloud.points.data.size());
  if (header.is_fortran)
    cloud.points.data = fromFortranOrder (cloud.points);
  return cloud;
}

std::vector<double>
readNpyNumbers (const std::string& file)
{
  FileReader reader (file, "NumPy");
  const NpyHeader header = readNpyHeader (reader);
  const NumberType& type = supportedType (file, header);
  const std::vector<std::uint64_t>& shape = header.shape;
  const bool is_list =
      shape.size() == 1 || (shape.size() == 2 && (shape[0] == 1 || shape[1] == 1));
  if (!is_list)
    throw WorkError (file,
                     "has an array of another shape than (N,); save a number for each "
                     "point");
  const std::uint64_t count = shape[0] * (shape.size() == 2 ? shape[1] : 1);
  const std::uint64_t data_size = reader.bytesLeft();
  if (count > data_size / type.size)
    reader.failTruncated();
  if (count * type.size != data_size)
    reader.fail ("it has more numbers than its shape says");
  std::vector<std::uint8_t> data (data_size);
  reader.read (data.data(), data.size());
  std::vector<double> numbers (count);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = type.read (&data[i * type.size]);
  return numbers;
}

} // namespace pcl_ops::apps

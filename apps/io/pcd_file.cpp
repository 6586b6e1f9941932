// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_formats.h"
#include "file_reader.h"
#include "number_types.h"

#include <algorithm>
#include <array>
#include <limits>
#include <locale>
#include <map>
#include <sstream>

namespace pcl_ops::apps {

namespace {

/** \brief The lines of a header by their keywords, each as its words without the
 * keyword.
 */
using PcdHeader = std::map<std::string, Words>;

PcdHeader
readHeader (FileReader& reader)
{
  const std::string last_key = "DATA";
  PcdHeader header;
  while (header.count (last_key) == 0) {
    Words words = reader.nextHeaderLine (last_key);
    if (words.empty() || words[0][0] == '#')
      continue;
    const std::string key = words[0] == "COLUMNS" ? "FIELDS" : words[0];
    if (!isPcdKey (key))
      reader.fail ("its line " + key + " is unknown");
    if (!header.emplace (key, Words (words.begin() + 1, words.end())).second)
      reader.fail ("its line " + key + " is there twice");
  }
  return header;
}

/** \brief Returns the words of the line with a keyword.
 * \throws WorkError if the header has no such line */
const Words&
lineOf (const FileReader& reader, const PcdHeader& header, const char* key)
{
  const auto line = header.find (key);
  if (line == header.end())
    reader.fail (std::string ("it has no line ") + key);
  return line->second;
}

/** \brief Declares the fields by the lines FIELDS, SIZE, TYPE and COUNT. */
void
readFields (const FileReader& reader,
            const PcdHeader& header,
            pcl::PCLPointCloud2& points)
{
  const Words& names = lineOf (reader, header, "FIELDS");
  const Words& sizes = lineOf (reader, header, "SIZE");
  const Words& types = lineOf (reader, header, "TYPE");
  const Words counts =
      header.count ("COUNT") > 0 ? header.at ("COUNT") : Words (names.size(), "1");
  if (names.empty())
    reader.fail ("FIELDS names none");
  if (sizes.size() != names.size() || types.size() != names.size() ||
      counts.size() != names.size())
    reader.fail ("FIELDS, SIZE, TYPE and COUNT differ in length");

  constexpr std::uint64_t max_count = 1U << 20U; // far above that of any descriptor
  // PCL's readers refuse larger points.
  constexpr std::uint64_t max_point_size = std::numeric_limits<std::int32_t>::max();
  std::uint64_t point_size = 0; // [bytes]
  for (std::size_t i = 0; i < names.size(); ++i) {
    const NumberType* const type = findNumberType ([&] (const NumberType& known) {
      return types[i] + sizes[i] == known.kind + std::to_string (known.size);
    });
    if (type == nullptr)
      reader.fail ("TYPE " + types[i] + " with SIZE " + sizes[i] + " does not exist");
    const std::uint64_t count = reader.parseCount ("COUNT", counts[i]);
    if (count > max_count)
      reader.fail ("COUNT " + counts[i] + " is out of range");
    if (count > 0) // fields of COUNT 0 are left out, as by PCL
      addField (names[i], type->id, points, static_cast<pcl::uindex_t> (count));
    point_size += count * type->size;
    if (point_size > max_point_size)
      reader.fail ("its points do not have 1 to " + std::to_string (max_point_size) +
                   " bytes each");
  }
  if (point_size == 0)
    reader.fail ("its points have no numbers");
}

/** \brief Sets width and height by the lines WIDTH, HEIGHT and POINTS. */
void
readSize (const FileReader& reader,
          const PcdHeader& header,
          pcl::PCLPointCloud2& points)
{
  const auto count_of = [&] (const std::string& key) {
    const Words& line = lineOf (reader, header, key.c_str());
    if (line.size() != 1)
      reader.fail (key + " is not one number");
    return reader.parseCount (key, line[0]);
  };
  const std::uint64_t size = count_of ("POINTS");
  std::uint64_t width = count_of ("WIDTH");
  std::uint64_t height = header.count ("HEIGHT") > 0 ? count_of ("HEIGHT") : 1;
  if (width == 0 && height <= 1) { // some writers set only POINTS
    width = size;
    height = 1;
  }
  if (width * height != size)
    reader.fail ("WIDTH times HEIGHT is not POINTS");
  if (size == 0)
    reader.failEmpty();
  points.width = static_cast<pcl::uindex_t> (width);
  points.height = static_cast<pcl::uindex_t> (height);
}

/** \brief Sets the pose by the line VIEWPOINT, if there is one. */
void
readViewpoint (const FileReader& reader, const PcdHeader& header, FileCloud& cloud)
{
  const auto line = header.find ("VIEWPOINT");
  if (line == header.end())
    return;
  std::array<double, 7> numbers{};
  bool are_numbers = line->second.size() == numbers.size();
  for (std::size_t i = 0; are_numbers && i < numbers.size(); ++i)
    are_numbers =
        numberType (pcl::PCLPointField::FLOAT64).parse (line->second[i], &numbers[i]);
  if (!are_numbers)
    reader.fail ("VIEWPOINT is not seven numbers");
  cloud.origin << numbers[0], numbers[1], numbers[2];
  cloud.orientation = {numbers[3], numbers[4], numbers[5], numbers[6]};
}

/** \brief Reads ascii data, a line for each point. */
void
readText (FileReader& reader, pcl::PCLPointCloud2& points)
{
  std::size_t numbers_per_point = 0;
  for (const pcl::PCLPointField& field : points.fields)
    numbers_per_point += field.count;
  constexpr std::uint64_t min_number_size = 2; // [bytes], a digit and a separator
  const std::uint64_t min_point_size = min_number_size * numbers_per_point;
  // The last number of the file may lack its separator.
  if (sizeOf (points) > (reader.bytesLeft() + 1) / min_point_size)
    reader.failTruncated();
  points.data.resize (sizeOf (points) * points.point_step);
  std::uint8_t* out = points.data.data();
  while (out != points.data.data() + points.data.size()) {
    if (!reader.nextNumbers())
      continue; // an empty line is skipped, as by PCL's reader
    reader.expectWordCount (numbers_per_point);
    std::size_t word = 0;
    for (const pcl::PCLPointField& field : points.fields) {
      const NumberType& type = numberType (field.datatype);
      for (pcl::uindex_t i = 0; i < field.count; ++i, out += type.size)
        reader.readNumber (word++, type, out);
    }
  }
  reader.expectEnd();
}

/** \brief Decompresses bytes of the LZF format (M. Lehmann's LibLZF), without PCL's
 * library, which loads VTK. The format is a sequence of chunks of two kinds. The first
 * byte of a chunk, its head, is 32 l + r, with l from 0 to 7 and r from 0 to 31.
 * - l = 0: r + 1 bytes follow, which are copied to the output.
 * - l > 0: bytes of the output so far are repeated. Their number is l + 2, but if l =
 * 7, it is 9 + the second byte of the chunk. They begin 256 r + b + 1 bytes before the
 * end of the output, where b is the last byte of the chunk. */
class LzfDecoder {
public:
  /** \param[out] output has the expected size */
  LzfDecoder (const std::vector<std::uint8_t>& compressed,
              std::vector<std::uint8_t>& output)
  : compressed_ (compressed), output_ (output)
  {}

  /** \return false if the compressed bytes do not make as many as expected */
  bool
  decompress ()
  {
    while (bytes_read_ < compressed_.size()) {
      const std::size_t head = compressed_[bytes_read_];
      ++bytes_read_;
      const bool is_run_of_literals = head < l_factor;
      if (is_run_of_literals && !copyLiterals (head + 1))
        return false;
      if (!is_run_of_literals && !repeat (head))
        return false;
    }
    return bytes_written_ == output_.size();
  }

private:
  /** \brief A head is l * l_factor + r. */
  static constexpr std::size_t l_factor = 32;

  /** \brief Copies bytes of a chunk with l = 0.
   * \return false if they exceed the input or the output */
  bool
  copyLiterals (std::size_t count)
  {
    if (count > compressed_.size() - bytes_read_ ||
        count > output_.size() - bytes_written_)
      return false;
    std::copy_n (&compressed_[bytes_read_], count, &output_[bytes_written_]);
    bytes_read_ += count;
    bytes_written_ += count;
    return true;
  }

  /** \brief Repeats bytes of the output, as a chunk with l > 0 says.
   * \return false if the chunk exceeds the input, or the bytes exceed the output */
  bool
  repeat (std::size_t head)
  {
    constexpr std::size_t l_of_long_chunk = 7;
    constexpr std::size_t min_count = 2, min_distance = 1;
    const std::size_t l = head / l_factor, r = head % l_factor;
    const bool is_long = l == l_of_long_chunk;
    const std::size_t bytes_behind_head = is_long ? 2 : 1;
    if (bytes_behind_head > compressed_.size() - bytes_read_)
      return false;
    std::size_t count = l + min_count;
    if (is_long) {
      count += compressed_[bytes_read_];
      ++bytes_read_;
    }
    const std::size_t distance = 256 * r + compressed_[bytes_read_] + min_distance;
    ++bytes_read_;
    if (distance > bytes_written_ || count > output_.size() - bytes_written_)
      return false;
    for (; count > 0; --count, ++bytes_written_) // source and target may overlap
      output_[bytes_written_] = output_[bytes_written_ - distance];
    return true;
  }

  const std::vector<std::uint8_t>& compressed_;
  std::vector<std::uint8_t>& output_;
  std::size_t bytes_read_ = 0, bytes_written_ = 0;
};

/** \brief Reads binary_compressed data, which have the values of all points field by
 * field. */
void
readCompressed (FileReader& reader, pcl::PCLPointCloud2& points)
{
  constexpr std::uint64_t max_expansion = 88; // LZF makes at most 264 bytes of 3
  struct Sizes {
    std::uint32_t compressed, expanded;
  };
  const std::size_t size = sizeOf (points);
  Sizes byte_counts{};
  reader.read (&byte_counts, sizeof (byte_counts));
  if (byte_counts.expanded != size * points.point_step)
    reader.fail ("the size of its compressed data is not that of its points");
  if (byte_counts.compressed > reader.bytesLeft() ||
      byte_counts.expanded > max_expansion * byte_counts.compressed)
    reader.failTruncated();
  std::vector<std::uint8_t> compressed (byte_counts.compressed);
  std::vector<std::uint8_t> by_field (byte_counts.expanded);
  reader.read (compressed.data(), compressed.size());
  if (!LzfDecoder (compressed, by_field).decompress())
    reader.fail ("its compressed data are damaged");
  points.data.resize (by_field.size());
  const std::uint8_t* from = by_field.data();
  for (const pcl::PCLPointField& field : points.fields) {
    const std::size_t length = field.count * numberType (field.datatype).size;
    for (std::size_t i = 0; i < size; ++i, from += length)
      std::copy_n (from, length, &points.data[i * points.point_step + field.offset]);
  }
}

void
readBinary (FileReader& reader, pcl::PCLPointCloud2& points)
{
  if (sizeOf (points) > reader.bytesLeft() / points.point_step)
    reader.failTruncated();
  points.data.resize (sizeOf (points) * points.point_step);
  reader.read (points.data.data(), points.data.size());
}

} // namespace

bool
isPcdKey (const std::string& word)
{
  static const std::string keys =
      " VERSION FIELDS COLUMNS SIZE TYPE COUNT WIDTH HEIGHT VIEWPOINT POINTS DATA ";
  return keys.find (" " + word + " ") != std::string::npos;
}

FileCloud
readPcd (const std::string& file)
{
  FileReader reader (file, "PCD");
  const PcdHeader header = readHeader (reader);
  FileCloud cloud;
  readFields (reader, header, cloud.points);
  readSize (reader, header, cloud.points);
  readViewpoint (reader, header, cloud);
  const Words& encoding = header.at ("DATA");
  if (encoding == Words{"ascii"})
    readText (reader, cloud.points);
  else if (encoding == Words{"binary"})
    readBinary (reader, cloud.points);
  else if (encoding == Words{"binary_compressed"})
    readCompressed (reader, cloud.points);
  else
    reader.fail ("DATA is not ascii, binary or binary_compressed");
  return cloud;
}

namespace {

/** \brief Returns the shortest text, of up to 6 significant digits or of as many as are
 * needed, that is read back as the same number; as the same float if the number is one.
 */
std::string
textOf (double number)
{
  constexpr int min_digits = 6; // as a stream writes by default
  const bool is_single = static_cast<double> (static_cast<float> (number)) == number;
  std::string text;
  double number_read = NAN;
  for (int digits = min_digits; digits <= std::numeric_limits<double>::max_digits10;
       ++digits) {
    std::ostringstream stream;
    stream.imbue (std::locale::classic());
    stream.precision (digits);
    stream << number;
    text = stream.str();
    numberType (pcl::PCLPointField::FLOAT64).parse (text, &number_read);
    if (number_read == number ||
        (is_single && static_cast<float> (number_read) == number))
      break;
  }
  return text;
}

} // namespace

std::string
pcdHeader (const FileCloud& cloud)
{
  std::string names;
  std::string sizes;
  std::string types;
  std::string counts;
  const pcl::PCLPointCloud2& points = cloud.points;
  const auto add_field =
      [&] (const std::string& name, const NumberType& type, pcl::uindex_t count) {
        names += " " + name;
        sizes += " " + std::to_string (type.size);
        types += std::string (" ") + type.kind;
        counts += " " + std::to_string (count);
      };
  pcl::uindex_t end = 0; // offset in a point of the end of the fields so far [bytes]
  const auto pad_up_to = [&] (pcl::uindex_t offset) {
    if (offset > end) // PCD calls padding _
      add_field ("_", numberType (pcl::PCLPointField::UINT8), offset - end);
  };
  for (const pcl::PCLPointField& field : points.fields) {
    const NumberType& type = numberType (field.datatype);
    pad_up_to (field.offset);
    add_field (field.name, type, field.count);
    end = field.offset + static_cast<pcl::uindex_t> (field.count * type.size);
  }
  pad_up_to (points.point_step);
  const Eigen::Quaterniond& q = cloud.orientation;
  std::ostringstream header;
  header.imbue (std::locale::classic());
  header << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" << names
         << "\nSIZE" << sizes << "\nTYPE" << types << "\nCOUNT" << counts << "\nWIDTH "
         << points.width << "\nHEIGHT " << points.height << "\nVIEWPOINT "
         << textOf (cloud.origin[0]) << ' ' << textOf (cloud.origin[1]) << ' '
         << textOf (cloud.origin[2]) << ' ' << textOf (q.w()) << ' ' << textOf (q.x())
         << ' ' << textOf (q.y()) << ' ' << textOf (q.z()) << "\nPOINTS "
         << sizeOf (points) << "\nDATA binary\n";
  return header.str();
}

} // namespace pcl_ops::apps

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

/** \brief The words of each line of the header, without the keyword, by the keyword. */
using PcdHeader = std::map<std::string, Words>;

PcdHeader
readHeader (FileReader& reader)
{
  const std::string last_key = "DATA";
  PcdHeader header;
  while (header.count (last_key) == 0) {
    Words words =
        reader.nextHeaderLine (last_key); // for the message if the file ends before
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

/** \throws WorkError if the header has no such line */
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
  // PCL's readers take points of at most as many bytes.
  constexpr std::uint64_t max_bytes = std::numeric_limits<std::int32_t>::max();
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto* const type = findNumberType ([&] (const NumberType& known) {
      return types[i] + sizes[i] == known.kind + std::to_string (known.size);
    });
    if (type == nullptr)
      reader.fail ("TYPE " + types[i] + " with SIZE " + sizes[i] + " does not exist");
    const std::uint64_t count = reader.parseCount ("COUNT", counts[i]);
    if (count > max_count)
      reader.fail ("COUNT " + counts[i] + " is out of range");
    if (count > 0) // PCL drops fields of COUNT 0, too
      addField (names[i], type->id, points, static_cast<pcl::uindex_t> (count));
    bytes += count * type->size;
    if (bytes > max_bytes)
      reader.fail ("its points do not have 1 to " + std::to_string (max_bytes) +
                   " bytes each");
  }
  if (bytes == 0)
    reader.fail ("its points have no numbers");
}

void
readSize (const FileReader& reader,
          const PcdHeader& header,
          pcl::PCLPointCloud2& points)
{
  const auto value = [&] (const std::string& key) {
    const Words& line = lineOf (reader, header, key.c_str());
    if (line.size() != 1)
      reader.fail (key + " is not one number");
    return reader.parseCount (key, line[0]);
  };
  const std::uint64_t size = value ("POINTS");
  std::uint64_t width = value ("WIDTH");
  std::uint64_t height = header.count ("HEIGHT") > 0 ? value ("HEIGHT") : 1;
  if (width == 0 && height <= 1) { // some writers leave the size out
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

void
readText (FileReader& reader, pcl::PCLPointCloud2& points)
{
  std::size_t numbers = 0;
  for (const pcl::PCLPointField& field : points.fields)
    numbers += field.count;
  // A number takes at least two bytes, a digit and a separator, which the last one may
  // lack.
  constexpr std::uint64_t min_bytes_of_number = 2;
  if (sizeOf (points) > (reader.bytesLeft() + 1) / (min_bytes_of_number * numbers))
    reader.failTruncated();
  points.data.resize (sizeOf (points) * points.point_step);
  std::uint8_t* out = points.data.data();
  while (out != points.data.data() + points.data.size()) {
    if (!reader.nextNumbers())
      continue; // an empty line, which PCL's reader skips, too
    reader.expectWordCount (numbers);
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
 * byte of a chunk, its head, has two parts: l, the upper 3 bits, and r, the lower 5.
 * - l = 0: r + 1 bytes follow, which are copied to the output.
 * - else: bytes of the output are repeated. Their number is l + 2; if l = 7, the next
 *   byte of the chunk is added to it. How far back in the output they begin is
 *   256 r + the last byte of the chunk + 1. */
class LzfDecoder {
public:
  /** \param[out] bytes of the expected size */
  LzfDecoder (const std::vector<std::uint8_t>& compressed,
              std::vector<std::uint8_t>& bytes)
  : compressed_ (compressed), bytes_ (bytes)
  {}

  /** \return false if the compressed bytes do not make as many as expected */
  bool
  decompress ()
  {
    while (in_ < compressed_.size()) {
      const std::size_t head = compressed_[in_];
      ++in_;
      if (head < lower_part) {
        if (!copyLiterals (head + 1))
          return false;
      }
      else if (!repeat (head))
        return false;
    }
    return out_ == bytes_.size();
  }

private:
  /** \brief A head is l * lower_part + r. */
  static constexpr std::size_t lower_part = 32;

  bool
  copyLiterals (std::size_t count)
  {
    if (count > compressed_.size() - in_ || count > bytes_.size() - out_)
      return false;
    std::copy_n (&compressed_[in_], count, &bytes_[out_]);
    in_ += count;
    out_ += count;
    return true;
  }

  /** \brief Copies bytes from earlier in the output. */
  bool
  repeat (std::size_t head)
  {
    constexpr std::size_t longest_in_head = 7; // of l
    constexpr std::size_t min_count = 2, min_distance = 1;
    std::size_t count = head / lower_part;
    const bool is_long = count == longest_in_head;
    const std::size_t bytes_left_of_chunk = is_long ? 2 : 1;
    if (bytes_left_of_chunk > compressed_.size() - in_)
      return false;
    if (is_long) {
      count += compressed_[in_];
      ++in_;
    }
    count += min_count;
    const std::size_t high_byte = head % lower_part;
    const std::size_t distance = high_byte * 256 + compressed_[in_] + min_distance;
    ++in_;
    if (distance > out_ || count > bytes_.size() - out_)
      return false;
    for (; count > 0; --count, ++out_) // source and target may overlap
      bytes_[out_] = bytes_[out_ - distance];
    return true;
  }

  const std::vector<std::uint8_t>& compressed_;
  std::vector<std::uint8_t>& bytes_;
  /** \brief Numbers of bytes read and written so far. */
  std::size_t in_ = 0, out_ = 0;
};

/** \brief Reads binary_compressed data, which have the values of all points field by
 * field. */
void
readCompressed (FileReader& reader, pcl::PCLPointCloud2& points)
{
  // LZF expands three bytes to at most 264.
  constexpr std::uint64_t max_expansion = 100;
  struct Sizes {
    std::uint32_t compressed, expanded;
  };
  const std::size_t size = sizeOf (points);
  Sizes bytes{};
  reader.read (&bytes, sizeof (bytes));
  if (bytes.expanded != size * points.point_step)
    reader.fail ("the size of its compressed data is not that of its points");
  if (bytes.compressed > reader.bytesLeft() ||
      bytes.expanded > max_expansion * bytes.compressed)
    reader.failTruncated();
  std::vector<std::uint8_t> compressed (bytes.compressed);
  std::vector<std::uint8_t> by_field (bytes.expanded);
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

/** \brief Returns the shortest text that is read back as the same number; in single
 * precision if the number fits it. */
std::string
textOf (double number)
{
  constexpr int first_digits = 6; // those of a stream by default
  const bool is_single = static_cast<double> (static_cast<float> (number)) == number;
  std::string text;
  double read = NAN;
  for (int digits = first_digits; digits <= std::numeric_limits<double>::max_digits10;
       ++digits) {
    std::ostringstream stream;
    stream.imbue (std::locale::classic());
    stream.precision (digits);
    stream << number;
    text = stream.str();
    numberType (pcl::PCLPointField::FLOAT64).parse (text, &read);
    if (read == number || (is_single && static_cast<float> (read) == number))
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
  const auto add = [&] (const std::string& name, const NumberType& type, auto count) {
    names += " " + name;
    sizes += " " + std::to_string (type.size);
    types += std::string (" ") + type.kind;
    counts += " " + std::to_string (count);
  };
  pcl::uindex_t end = 0; // of the fields so far, in a point [bytes]
  const auto pad_up_to = [&] (pcl::uindex_t offset) {
    if (offset > end) // PCD calls padding _
      add ("_", numberType (pcl::PCLPointField::UINT8), offset - end);
  };
  for (const pcl::PCLPointField& field : points.fields) {
    const NumberType& type = numberType (field.datatype);
    pad_up_to (field.offset);
    add (field.name, type, field.count);
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

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcd_header.h"

#include "header_reader.h"
#include "number_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_ops::apps {

namespace {

/** \brief The lines of a PCD header that say how much data follows. */
struct PcdHeader {
  std::map<std::string, Words> lines;
  std::uint64_t data_offset = 0;
};

constexpr std::array<std::string_view, 10> known_keys = {"VERSION",
                                                         "FIELDS",
                                                         "SIZE",
                                                         "TYPE",
                                                         "COUNT",
                                                         "WIDTH",
                                                         "HEIGHT",
                                                         "VIEWPOINT",
                                                         "POINTS",
                                                         "DATA"};

PcdHeader
readPcdHeader (HeaderReader& reader)
{
  PcdHeader header;
  while (header.lines.count ("DATA") == 0) {
    Words words = reader.nextLine ("DATA");
    if (words.empty() || words[0][0] == '#')
      continue;
    const std::string key = words[0] == "COLUMNS" ? "FIELDS" : words[0];
    if (std::find (known_keys.begin(), known_keys.end(), key) == known_keys.end())
      reader.fail ("its line " + key + " is unknown");
    if (!header.lines.emplace (key, Words (words.begin() + 1, words.end())).second)
      reader.fail ("its line " + key + " is there twice");
  }
  header.data_offset = reader.position();
  return header;
}

/** \brief Bytes of a number. */
std::uint64_t
numberSize (const HeaderReader& reader,
            const std::string& type,
            const std::string& size)
{
  static const std::array<std::string, 10> known_types = {
      "I1", "I2", "I4", "I8", "U1", "U2", "U4", "U8", "F4", "F8"};
  if (std::find (known_types.begin(), known_types.end(), type + size) ==
      known_types.end())
    reader.fail ("TYPE " + type + " with SIZE " + size + " does not exist");
  return reader.number ("SIZE", size);
}

/** \brief What a point takes, summed over the fields. */
struct PointSize {
  std::uint64_t bytes = 0;
  std::uint64_t numbers = 0;
};

PointSize
pointSize (const HeaderReader& reader, const PcdHeader& header)
{
  const auto line = [&] (const std::string& key) {
    const auto found = header.lines.find (key);
    if (found == header.lines.end())
      reader.fail ("it has no line " + key);
    return found->second;
  };
  const Words fields = line ("FIELDS"), sizes = line ("SIZE"), types = line ("TYPE");
  const Words counts =
      header.lines.count ("COUNT") > 0 ? line ("COUNT") : Words (fields.size(), "1");
  if (fields.empty())
    reader.fail ("FIELDS names none");
  if (sizes.size() != fields.size() || types.size() != fields.size() ||
      counts.size() != fields.size())
    reader.fail ("FIELDS, SIZE, TYPE and COUNT differ in length");

  constexpr std::uint64_t most_per_field = 1U << 20U;
  // PCL's reader sums them up in an int.
  constexpr std::uint64_t most_bytes = std::numeric_limits<std::int32_t>::max();
  PointSize size;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::uint64_t number_size = numberSize (reader, types[i], sizes[i]);
    const std::uint64_t count = reader.number ("COUNT", counts[i]);
    if (count == 0 || count > most_per_field)
      reader.fail ("COUNT " + counts[i] + " is out of range");
    size.numbers += count;
    size.bytes += count * number_size;
  }
  if (size.bytes < 1 || size.bytes > most_bytes)
    reader.fail ("its points do not have 1 to " + std::to_string (most_bytes) +
                 " bytes each");
  return size;
}

/** \brief POINTS, which has to agree with WIDTH and HEIGHT where they are given. */
std::uint64_t
pointCount (const HeaderReader& reader, const PcdHeader& header)
{
  const auto value = [&] (const std::string& key) {
    const auto line = header.lines.find (key);
    if (line == header.lines.end())
      reader.fail ("it has no line " + key);
    if (line->second.size() != 1)
      reader.fail (key + " is not one number");
    return reader.count (key, line->second[0]);
  };
  const std::uint64_t points = value ("POINTS");
  const std::uint64_t width = value ("WIDTH");
  const std::uint64_t height = header.lines.count ("HEIGHT") > 0 ? value ("HEIGHT") : 1;
  if (width * height != points)
    reader.fail ("WIDTH times HEIGHT is not POINTS");
  return points;
}

Viewpoint
viewpointOf (const HeaderReader& reader, const PcdHeader& header)
{
  const auto line = header.lines.find ("VIEWPOINT");
  if (line == header.lines.end())
    return {};
  std::array<float, 7> numbers{};
  bool are_numbers = line->second.size() == numbers.size();
  for (std::size_t i = 0; are_numbers && i < numbers.size(); ++i) {
    char* end = nullptr;
    numbers[i] = std::strtof (line->second[i].c_str(), &end);
    are_numbers = *end == '\0';
  }
  if (!are_numbers)
    reader.fail ("VIEWPOINT is not seven numbers");
  return {{numbers[0], numbers[1], numbers[2]},
          {numbers[3], numbers[4], numbers[5], numbers[6]}};
}

/** \brief Data that begins like a line of a header, behind empty lines and comments:
 * PCL's reader takes it for one, and what it makes of that is not defined. */
void
checkDataIsNoHeader (HeaderReader& reader, const PcdHeader& header)
{
  constexpr std::uint64_t looked_at = 1U << 16U;
  std::string head (std::min (reader.fileSize() - header.data_offset, looked_at), '\0');
  reader.read (head.data(), head.size());
  reader.goTo (header.data_offset);
  std::istringstream lines (head);
  for (std::string line; std::getline (lines, line);) {
    const std::size_t word = line.find_first_not_of (" \t\r\v\f");
    if (word == std::string::npos || line[word] == '#')
      continue;
    const auto begins_with = [&] (std::string_view key) {
      return line.compare (word, key.size(), key) == 0;
    };
    if (begins_with ("COLUMNS") ||
        std::any_of (known_keys.begin(), known_keys.end(), begins_with))
      reader.fail ("there are lines of a header behind DATA");
    return;
  }
}

/** \brief A compressed body starts with its compressed and uncompressed size. */
void
checkCompressed (HeaderReader& reader,
                 std::uint64_t rest,
                 std::uint64_t points,
                 std::uint64_t point_size)
{
  std::array<std::uint32_t, 2> sizes{};
  if (rest < sizeof (sizes))
    reader.failTruncated();
  reader.read (reinterpret_cast<char*> (sizes.data()), sizeof (sizes));
  if (rest - sizeof (sizes) < sizes[0])
    reader.failTruncated();
  if (sizes[1] % point_size != 0 || sizes[1] / point_size != points)
    reader.fail ("the size of its compressed data is not that of its points");
  // LZF makes 264 bytes of three at best.
  constexpr std::uint64_t most_expansion = 100;
  if (sizes[1] > most_expansion * sizes[0])
    reader.failTruncated();
}

void
checkAscii (HeaderReader& reader, std::uint64_t points, std::uint64_t numbers)
{
  NumberLines lines (reader);
  for (std::uint64_t point = 0; point < points;) {
    if (!lines.next())
      continue; // PCL's reader skips it, too
    lines.expectNumbers (numbers);
    ++point;
  }
  lines.expectEnd();
}

} // namespace

Viewpoint
checkPcdFile (const std::string& file)
{
  HeaderReader reader (file, "PCD");
  const PcdHeader header = readPcdHeader (reader);
  const PointSize size = pointSize (reader, header);
  const std::uint64_t points = pointCount (reader, header);
  if (points == 0)
    reader.failEmpty();
  const Viewpoint viewpoint = viewpointOf (reader, header);
  const std::uint64_t rest = reader.fileSize() - header.data_offset;
  const Words& data = header.lines.at ("DATA");
  const std::string kind = data.size() == 1 ? data[0] : "";
  if (kind != "ascii")
    checkDataIsNoHeader (reader, header);
  // The shortest ascii number is a digit and a separator.
  const std::uint64_t ascii_size = 2 * size.numbers;
  if (kind == "binary_compressed")
    checkCompressed (reader, rest, points, size.bytes);
  else if (kind != "ascii" && kind != "binary")
    reader.fail ("DATA is not ascii, binary or binary_compressed");
  else if (points > (rest + 1) / (kind == "binary" ? size.bytes : ascii_size))
    reader.failTruncated();
  else if (kind == "ascii")
    checkAscii (reader, points, size.numbers);
  return viewpoint;
}

} // namespace pcl_ops::apps

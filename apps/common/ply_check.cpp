// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_file_check.h"
#include "file_header.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>

namespace pcl_ops::apps {

namespace {

/** \brief What a PLY header says about the length of its data. */
struct PlyHeader {
  std::string format;
  bool has_vertices = false;
  /** \brief Fewest bytes the data can have in binary. */
  std::uint64_t binary_size = 0;
  /** \brief Fewest bytes it can have in ascii: a digit and a separator per number. */
  std::uint64_t ascii_size = 0;
};

std::uint64_t
sizeOfType (const HeaderReader& reader, const std::string& type)
{
  static const std::array<std::pair<const char*, std::uint64_t>, 16> kSizes = {
      {{"char", 1},
       {"uchar", 1},
       {"short", 2},
       {"ushort", 2},
       {"int", 4},
       {"uint", 4},
       {"float", 4},
       {"double", 8},
       {"int8", 1},
       {"uint8", 1},
       {"int16", 2},
       {"uint16", 2},
       {"int32", 4},
       {"uint32", 4},
       {"float32", 4},
       {"float64", 8}}};
  for (const auto& [name, size] : kSizes)
    if (type == name)
      return size;
  reader.fail ("the property type " + type + " does not exist");
}

PlyHeader
readPlyHeader (HeaderReader& reader)
{
  PlyHeader header;
  if (reader.nextLine ("ply") != Words{"ply"})
    reader.fail ("its first line is not ply");
  std::uint64_t instances = 0;
  for (Words words; words != Words{"end_header"};) {
    words = reader.nextLine ("end_header");
    const std::string key = words.empty() ? "" : words[0];
    if (key == "format" && words.size() == 3)
      header.format = words[1];
    else if (key == "element" && words.size() == 3) {
      instances = reader.count ("element " + words[1], words[2]);
      header.has_vertices = header.has_vertices || words[1] == "vertex";
    }
    else if (key == "property" && words.size() >= 3) {
      // A list may be empty: then it is its length alone.
      header.binary_size +=
          instances * sizeOfType (reader, words[1] == "list" ? words[2] : words[1]);
      header.ascii_size += 2 * instances;
    }
    else if (key == "format" || key == "element" || key == "property")
      reader.fail ("its line " + key + " is incomplete");
  }
  return header;
}

} // namespace

void
checkPlyFile (const std::string& file)
{
  HeaderReader reader (file, "PLY");
  const PlyHeader header = readPlyHeader (reader);
  const bool is_ascii = header.format == "ascii";
  if (!is_ascii && header.format != "binary_little_endian" &&
      header.format != "binary_big_endian")
    reader.fail ("its format is not ascii, binary_little_endian or binary_big_endian");
  if (!header.has_vertices)
    reader.fail ("it has no element vertex");
  const std::uint64_t rest = reader.fileSize() - reader.position();
  if (rest + 1 < (is_ascii ? header.ascii_size : header.binary_size))
    reader.failTruncated();
}

} // namespace pcl_ops::apps

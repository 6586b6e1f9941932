// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.h"

#include "header_reader.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace pcl_ops::apps {

namespace {

struct Property {
  std::string type;
  std::string name;
};

struct Element {
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct PlyHeader {
  std::string format;
  std::map<std::string, Element> elements;
  /** \brief "obj_info num_cols N" and "num_rows N", by which PCL's reader sizes clouds.
   */
  std::map<std::string, std::uint64_t> grid;
};

std::uint64_t
sizeOfType (const HeaderReader& reader, const std::string& type)
{
  static const std::map<std::string, std::uint64_t> known_sizes = {{"char", 1},
                                                                   {"uchar", 1},
                                                                   {"int8", 1},
                                                                   {"uint8", 1},
                                                                   {"short", 2},
                                                                   {"ushort", 2},
                                                                   {"int16", 2},
                                                                   {"uint16", 2},
                                                                   {"int", 4},
                                                                   {"uint", 4},
                                                                   {"int32", 4},
                                                                   {"uint32", 4},
                                                                   {"float", 4},
                                                                   {"double", 8},
                                                                   {"float32", 4},
                                                                   {"float64", 8}};
  const auto size = known_sizes.find (type);
  if (size == known_sizes.end())
    reader.fail ("the property type " + type + " does not exist");
  return size->second;
}

void
readElement (const HeaderReader& reader, const Words& words, PlyHeader& header)
{
  if (words.size() != 3)
    reader.fail ("its line element is incomplete");
  Element element;
  element.count = reader.count ("element " + words[1], words[2]);
  if (!header.elements.emplace (words[1], element).second)
    reader.fail ("it has the element " + words[1] + " twice");
}

void
readProperty (const HeaderReader& reader, const Words& words, Element* element)
{
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (element == nullptr || (words.size() != 3 && !is_list))
    reader.fail ("its line property is incomplete");
  element->properties.push_back ({words[1], words.back()});
  if (is_list)
    element->properties.back().type = "list " + words[2];
}

PlyHeader
readPlyHeader (HeaderReader& reader)
{
  PlyHeader header;
  if (reader.nextLine ("ply") != Words{"ply"})
    reader.fail ("its first line is not ply");
  Element* last = nullptr;
  for (Words words; words != Words{"end_header"};) {
    words = reader.nextLine ("end_header");
    const std::string key = words.empty() ? "" : words[0];
    if (key == "format" && words.size() == 3)
      header.format = words[1];
    else if (key == "element") {
      readElement (reader, words, header);
      last = &header.elements.at (words[1]);
    }
    else if (key == "property")
      readProperty (reader, words, last);
    else if (key == "obj_info") {
      if (words.size() > 2 && (words[1] == "num_cols" || words[1] == "num_rows"))
        header.grid[words[1]] = reader.count (words[1], words[2]);
    }
    else if (key != "comment" && key != "end_header")
      reader.fail ("its line '" + key + "' is unknown or incomplete");
  }
  return header;
}

/** \brief What PCL's reader takes for granted of vertices and may crash without. */
void
checkVertices (const HeaderReader& reader, const PlyHeader& header)
{
  const auto vertex = header.elements.find ("vertex");
  if (vertex == header.elements.end())
    reader.fail ("it has no element vertex");
  std::set<std::string> names;
  std::string colors;
  for (const Property& property : vertex->second.properties) {
    if (property.type.find ("list") == 0)
      reader.fail ("its vertices have a list, " + property.name);
    if (!names.insert (property.name).second)
      reader.fail ("its vertices have " + property.name + " twice");
    std::string name = property.name;
    if (name.find ("diffuse_") == 0)
      name.erase (0, name.find ('_') + 1);
    const bool is_color =
        name == "red" || name == "green" || name == "blue" || property.name == "alpha";
    if (is_color && (property.type == "uchar" || property.type == "uint8"))
      colors += name[0];
  }
  if (colors != "" && colors != "rgb" && colors != "rgba")
    reader.fail ("the colours of its vertices are not red, green, blue[, alpha]");
}

/** \brief A grid has to hold every vertex, or PCL's reader writes past its end. */
void
checkGrid (const HeaderReader& reader, const PlyHeader& header)
{
  if (header.grid.empty())
    return;
  const auto range_grid = header.elements.find ("range_grid");
  const std::uint64_t vertices = header.elements.at ("vertex").count;
  const std::uint64_t cells =
      range_grid == header.elements.end() ? vertices : range_grid->second.count;
  if (header.grid.size() != 2 || vertices > cells ||
      header.grid.at ("num_cols") * header.grid.at ("num_rows") != cells)
    reader.fail ("num_cols times num_rows is not its number of points");
}

/** \brief Fewest bytes the data can have: lists may be empty, an ascii number is a
 * digit and a separator. */
std::uint64_t
smallestSize (const HeaderReader& reader, const PlyHeader& header)
{
  std::uint64_t bytes = 0;
  for (const auto& [name, element] : header.elements) {
    for (const Property& property : element.properties) {
      const std::string type = property.type.substr (property.type.find (' ') + 1);
      const std::uint64_t binary_size = sizeOfType (reader, type);
      bytes += element.count * (header.format == "ascii" ? 2 : binary_size);
    }
  }
  return bytes;
}

} // namespace

void
checkPlyFile (const std::string& file)
{
  HeaderReader reader (file, "PLY");
  const PlyHeader header = readPlyHeader (reader);
  if (header.format != "ascii" && header.format != "binary_little_endian" &&
      header.format != "binary_big_endian")
    reader.fail ("its format is not ascii, binary_little_endian or binary_big_endian");
  checkVertices (reader, header);
  if (header.elements.at ("vertex").count == 0)
    reader.failEmpty();
  checkGrid (reader, header);
  const std::uint64_t rest = reader.fileSize() - reader.position();
  if (rest + 1 < smallestSize (reader, header))
    reader.failTruncated();
}

} // namespace pcl_ops::apps

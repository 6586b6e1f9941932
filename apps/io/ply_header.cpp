// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.h"

#include <pcl/common/io.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>

#include "header_reader.h"
#include "ply_body.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace pcl_ops::apps {

namespace {

struct PlyHeader {
  PlyLayout layout;
  /** \brief "obj_info num_cols N" and "num_rows N", by which PCL's reader sizes clouds.
   */
  std::map<std::string, std::uint64_t> grid;
};

std::uint8_t
typeOf (const HeaderReader& reader, const std::string& name)
{
  using Field = pcl::PCLPointField;
  static const std::map<std::string, std::uint8_t> known_types = {
      {"char", Field::INT8},
      {"uchar", Field::UINT8},
      {"int8", Field::INT8},
      {"uint8", Field::UINT8},
      {"short", Field::INT16},
      {"ushort", Field::UINT16},
      {"int16", Field::INT16},
      {"uint16", Field::UINT16},
      {"int", Field::INT32},
      {"uint", Field::UINT32},
      {"int32", Field::INT32},
      {"uint32", Field::UINT32},
      {"float", Field::FLOAT32},
      {"double", Field::FLOAT64},
      {"float32", Field::FLOAT32},
      {"float64", Field::FLOAT64}};
  const auto type = known_types.find (name);
  if (type == known_types.end())
    reader.fail ("the property type " + name + " does not exist");
  return type->second;
}

constexpr std::size_t most_elements = 1000;
constexpr std::size_t most_properties = 10000;

void
readElement (const HeaderReader& reader, const Words& words, PlyLayout& layout)
{
  if (words.size() != 3)
    reader.fail ("its line element is incomplete");
  if (layout.elements.size() == most_elements)
    reader.fail ("it has more than " + std::to_string (most_elements) + " elements");
  if (layout.find (words[1]) != nullptr)
    reader.fail ("it has the element " + words[1] + " twice");
  layout.elements.push_back (
      {words[1], reader.count ("element " + words[1], words[2]), {}});
}

void
readProperty (const HeaderReader& reader, const Words& words, PlyLayout& layout)
{
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (layout.elements.empty() || (words.size() != 3 && !is_list))
    reader.fail ("its line property is incomplete");
  PlyProperty property{words.back(), typeOf (reader, words[words.size() - 2]), is_list};
  if (is_list)
    property.length_type = typeOf (reader, words[2]);
  PlyElement& element = layout.elements.back();
  if (element.properties.size() == most_properties)
    reader.fail ("its element " + element.name + " has more than " +
                 std::to_string (most_properties) + " properties");
  element.properties.push_back (property);
}

/** \brief The words of a line as PCL's reader takes them. */
Words
wordsBetweenBlanks (std::string line)
{
  line.erase (line.find_last_not_of (" \t\r") + 1);
  Words words;
  return boost::split (words, line, boost::is_any_of (" \t"), boost::token_compress_on);
}

void
readGrid (const HeaderReader& reader, const Words& words, PlyHeader& header)
{
  // PCL's reader ends the program at a line that is indented.
  if (wordsBetweenBlanks (reader.line()) != words)
    reader.failAtLine ("has white space in front of obj_info or other than blanks");
  if (words.size() > 2 && (words[1] == "num_cols" || words[1] == "num_rows"))
    header.grid[words[1]] = reader.count (words[1], words[2]);
}

PlyHeader
readPlyHeader (HeaderReader& reader)
{
  PlyHeader header;
  if (reader.nextLine ("ply") != Words{"ply"})
    reader.fail ("its first line is not ply");
  for (Words words; words != Words{"end_header"};) {
    words = reader.nextLine ("end_header");
    const std::string key = words.empty() ? "" : words[0];
    if (key == "format" && words.size() == 3)
      header.layout.format = words[1];
    else if (key == "element")
      readElement (reader, words, header.layout);
    else if (key == "property")
      readProperty (reader, words, header.layout);
    else if (key == "obj_info")
      readGrid (reader, words, header);
    else if (key != "comment" && key != "end_header")
      reader.fail ("its line '" + key + "' is unknown or incomplete");
  }
  return header;
}

/** \brief What PCL's reader takes for granted of vertices and may crash without. */
void
checkVertices (const HeaderReader& reader, const PlyLayout& layout)
{
  const PlyElement* const vertex = layout.find ("vertex");
  if (vertex == nullptr)
    reader.fail ("it has no element vertex");
  std::set<std::string> names;
  std::string colors;
  for (const PlyProperty& property : vertex->properties) {
    if (property.is_list)
      reader.fail ("its vertices have a list, " + property.name);
    if (!names.insert (property.name).second)
      reader.fail ("its vertices have " + property.name + " twice");
    std::string name = property.name;
    if (name.find ("diffuse_") == 0)
      name.erase (0, name.find ('_') + 1);
    const bool is_color =
        name == "red" || name == "green" || name == "blue" || property.name == "alpha";
    if (is_color && property.type == pcl::PCLPointField::UINT8)
      colors += name[0];
  }
  if (colors != "" && colors != "rgb" && colors != "rgba")
    reader.fail ("the colours of its vertices are not red, green, blue[, alpha]");
}

/** \brief Fewest bytes of an element: lists may be empty, an ascii number is a digit
 * and a separator. */
std::uint64_t
smallestSize (const PlyElement& element, bool is_text)
{
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes += is_text ? 2
                     : static_cast<std::uint64_t> (pcl::getFieldSize (
                           property.is_list ? property.length_type : property.type));
  return bytes;
}

std::uint64_t
smallestSize (const PlyLayout& layout)
{
  std::uint64_t bytes = 0;
  for (const PlyElement& element : layout.elements)
    bytes += element.count * smallestSize (element, layout.format == "ascii");
  return bytes;
}

/** \brief A grid has to hold every vertex, or PCL's reader writes past its end; and not
 * to be so empty that it takes more memory than such a file is worth. */
void
checkGrid (const HeaderReader& reader, const PlyHeader& header)
{
  const PlyElement& vertices = *header.layout.find ("vertex");
  const PlyElement* const range_grid = header.layout.find ("range_grid");
  const std::uint64_t cells =
      range_grid == nullptr ? vertices.count : range_grid->count;
  constexpr std::uint64_t most_expansion = 100;
  if (cells * smallestSize (vertices, false) > most_expansion * reader.fileSize())
    reader.failTruncated();
  if (header.grid.empty())
    return;
  if (header.grid.size() != 2 || vertices.count > cells ||
      header.grid.at ("num_cols") * header.grid.at ("num_rows") != cells)
    reader.fail ("num_cols times num_rows is not its number of points");
}

} // namespace

void
checkPlyFile (const std::string& file)
{
  HeaderReader reader (file, "PLY");
  const PlyHeader header = readPlyHeader (reader);
  const PlyLayout& layout = header.layout;
  if (layout.format != "ascii" && layout.format != "binary_little_endian" &&
      layout.format != "binary_big_endian")
    reader.fail ("its format is not ascii, binary_little_endian or binary_big_endian");
  checkVertices (reader, layout);
  if (layout.find ("vertex")->count == 0)
    reader.failEmpty();
  const std::uint64_t rest = reader.fileSize() - reader.position();
  if (rest + 1 < smallestSize (layout))
    reader.failTruncated();
  checkGrid (reader, header);
  checkPlyBody (reader, layout);
}

} // namespace pcl_ops::apps

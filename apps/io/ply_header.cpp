// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.h"

#include <algorithm>
#include <set>

namespace pcl_ops::apps {

namespace {

constexpr std::size_t max_elements = 1000, max_properties = 10000;

const NumberType*
typeOf (const HeaderReader& reader, const std::string& name)
{
  const NumberType* const type = findPlyType (name);
  if (type == nullptr)
    reader.fail ("the property type " + name + " does not exist");
  return type;
}

void
readElement (const HeaderReader& reader, const Words& words, PlyHeader& header)
{
  if (words.size() != 3)
    reader.fail ("its line element is incomplete");
  if (header.elements.size() == max_elements)
    reader.fail ("it has more than " + std::to_string (max_elements) + " elements");
  if (header.find (words[1]) != nullptr)
    reader.fail ("it has the element " + words[1] + " twice");
  header.elements.push_back (
      {words[1], reader.count ("element " + words[1], words[2]), {}});
}

void
readProperty (const HeaderReader& reader, const Words& words, PlyHeader& header)
{
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (header.elements.empty() || (words.size() != 3 && !is_list))
    reader.fail ("its line property is incomplete");
  PlyElement& element = header.elements.back();
  if (element.properties.size() == max_properties)
    reader.fail ("its element " + element.name + " has more than " +
                 std::to_string (max_properties) + " properties");
  element.properties.push_back ({words.back(),
                                 typeOf (reader, words[words.size() - 2]),
                                 is_list ? typeOf (reader, words[2]) : nullptr});
}

void
checkHeader (const HeaderReader& reader, const PlyHeader& header)
{
  if (header.format != "ascii" && header.format != "binary_little_endian" &&
      header.format != "binary_big_endian")
    reader.fail ("its format is not ascii, binary_little_endian or binary_big_endian");
  const PlyElement* const vertex = header.find ("vertex");
  if (vertex == nullptr)
    reader.fail ("it has no element vertex");
  std::set<std::string> names;
  for (const PlyProperty& property : vertex->properties) {
    if (property.length_type != nullptr)
      reader.fail ("its vertices have a list, " + property.name);
    if (!names.insert (property.name).second)
      reader.fail ("its vertices have " + property.name + " twice");
  }
  if (vertex->count == 0)
    reader.failEmpty();
}

} // namespace

const PlyElement*
PlyHeader::find (const std::string& name) const
{
  const auto found =
      std::find_if (elements.begin(), elements.end(), [&] (const PlyElement& element) {
        return element.name == name;
      });
  return found == elements.end() ? nullptr : &*found;
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
      header.format = words[1];
    else if (key == "element")
      readElement (reader, words, header);
    else if (key == "property")
      readProperty (reader, words, header);
    else if (key == "obj_info" && words.size() > 2 &&
             (words[1] == "num_cols" || words[1] == "num_rows"))
      header.grid[words[1]] = static_cast<double> (reader.count (words[1], words[2]));
    else if (key != "obj_info" && key != "comment" && key != "end_header")
      reader.fail ("its line '" + key + "' is unknown or incomplete");
  }
  checkHeader (reader, header);
  return header;
}

} // namespace pcl_ops::apps

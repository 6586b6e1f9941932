// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/endian/conversion.hpp>

#include "cloud_formats.h"
#include "header_reader.h"
#include "number_types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

struct PlyProperty {
  std::string name;
  const NumberType* type = nullptr;
  /** \brief Type of the length in front of a list; nullptr: no list. */
  const NumberType* length_type = nullptr;
  /** \brief Where the property begins in a point [bytes]. */
  pcl::uindex_t offset = 0;
  bool becomes_float = false;
};
using PlyProperties = std::vector<PlyProperty>;

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  PlyProperties properties;
  bool has_lists = false;
};

struct PlyHeader {
  /** \brief ascii, binary_little_endian or binary_big_endian. */
  std::string format;
  /** \brief In the order of the data. */
  std::vector<PlyElement> elements;
  /** \brief Numbers by name: num_cols and num_rows of obj_info, later those of the
   * camera element. */
  std::map<std::string, double> grid;

  /** \return nullptr if no element has the name */
  const PlyElement*
  find (const std::string& name) const
  {
    for (const PlyElement& element : elements)
      if (element.name == name)
        return &element;
    return nullptr;
  }
};

constexpr std::size_t max_elements = 1000, max_properties = 10000;

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
  const auto type_of = [&] (const std::string& name) {
    const auto* const type = findNumberType ([&] (const NumberType& known) {
      return name == known.ply_name || name == known.ply_name_with_bits;
    });
    if (type == nullptr)
      reader.fail ("the property type " + name + " does not exist");
    return type;
  };
  PlyElement& element = header.elements.back();
  if (element.properties.size() == max_properties)
    reader.fail ("its element " + element.name + " has more than " +
                 std::to_string (max_properties) + " properties");
  element.properties.push_back ({words.back(),
                                 type_of (words[words.size() - 2]),
                                 is_list ? type_of (words[2]) : nullptr});
  element.has_lists = element.has_lists || is_list;
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
    const bool is_number = property.length_type == nullptr;
    if (is_number && !names.insert (property.name).second)
      reader.fail ("its vertices have " + property.name + " twice");
  }
  if (vertex->count == 0)
    reader.failEmpty();
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

/** \brief Reads the data of a PLY, number by number. */
class PlyData {
public:
  PlyData (HeaderReader& reader, const std::string& format)
  : reader_ (reader), is_text_ (format == "ascii")
  {
    using boost::endian::order;
    is_swapped_ = (format == "binary_big_endian") != (order::native == order::big);
  }

  void
  beginElement ()
  {
    line_lengths_.clear();
  }

  void
  beginRow (const PlyElement& element)
  {
    next_word_ = 0;
    if (!is_text_)
      return;
    if (line_lengths_.size() > 1)
      return reader_.nextLines (line_lengths_);
    reader_.nextNumbers();
    if (element.has_lists)
      return;
    if (line_lengths_.empty())
      line_lengths_ = reader_.joinLines (element.properties.size());
    reader_.expectNumbers (element.properties.size());
  }

  void
  read (const NumberType& type, std::uint8_t* bytes)
  {
    if (is_text_)
      return reader_.readNumber (nextWord(), type, bytes);
    reader_.read (bytes, type.size);
    if (is_swapped_)
      std::reverse (bytes, bytes + type.size);
  }

  /** \return the last number of a list (0 if it is empty), or the number of a property
   * that is no list */
  double
  readProperty (const PlyProperty& property)
  {
    const double count =
        property.length_type == nullptr ? 1.0 : number (*property.length_type);
    if (!(count >= 0.0))
      failAtList();
    double last = 0.0;
    for (double i = 0.0; i < count; ++i)
      last = number (*property.type);
    return last;
  }

  void
  endRow () const
  {
    if (is_text_ && next_word_ != reader_.wordCount())
      failAtList();
  }

private:
  double
  number (const NumberType& type)
  {
    if (is_text_)
      return reader_.number (nextWord());
    std::uint8_t bytes[sizeof (double)];
    read (type, bytes);
    return type.read (bytes);
  }

  std::size_t
  nextWord ()
  {
    if (next_word_ == reader_.wordCount())
      failAtList();
    return next_word_++;
  }

  [[noreturn]] void
  failAtList () const
  {
    if (is_text_)
      reader_.failAtLine ("has a list of another length than it says");
    reader_.fail ("a list has no length");
  }

  HeaderReader& reader_;
  bool is_text_, is_swapped_ = false;
  std::size_t next_word_ = 0;
  /** \brief The number of words in each line of the first row of the element. */
  std::vector<std::size_t> line_lengths_;
};

/** \brief The names of the bytes of PCL's packed color, from the lowest. */
constexpr std::array<const char*, 4> color_names = {"blue", "green", "red", "alpha"};

/** \brief Returns the byte of PCL's packed color that a property of type uchar becomes;
 * -1 if it is no color. */
int
placeInColor (const PlyProperty& property)
{
  for (std::size_t i = 0; i < color_names.size(); ++i)
    if (property.type->id == PCLPointField::UINT8 &&
        (property.name == color_names[i] ||
         property.name == std::string ("diffuse_") + color_names[i]))
      return static_cast<int> (i);
  return -1;
}

/** \brief Adds the field of a property that is no part of a color. */
void
addOwnField (PlyProperty& property, pcl::PCLPointCloud2& points)
{
  const std::string& name = property.name;
  const bool is_normal = name == "nx" || name == "ny" || name == "nz";
  const std::uint8_t type = property.type->id;
  property.becomes_float = name == "intensity" && type == PCLPointField::UINT8;
  property.offset = points.point_step;
  addField (is_normal ? "normal_" + name.substr (1) : name,
            property.becomes_float ? std::uint8_t (PCLPointField::FLOAT32) : type,
            points);
}

/** \brief Adds the fields of the vertices with PCL's names: normals, a packed color,
 * and intensity as a float. Lists are left out, as no field has room for them. */
void
addFields (PlyElement& vertex, pcl::PCLPointCloud2& points)
{
  std::size_t color = 0; // index of the color field plus 1; 0: none yet
  for (PlyProperty& property : vertex.properties) {
    if (property.length_type != nullptr)
      continue;
    const int place = placeInColor (property);
    if (place < 0) {
      addOwnField (property, points);
      continue;
    }
    if (color == 0) {
      addField ("rgb", PCLPointField::FLOAT32, points);
      color = points.fields.size();
    }
    PCLPointField& field = points.fields[color - 1];
    if (property.name == "alpha") {
      field.name = "rgba";
      field.datatype = PCLPointField::UINT32;
    }
    property.offset = field.offset + static_cast<pcl::uindex_t> (place);
  }
  points.data.resize (vertex.count * points.point_step);
}

/** \brief Reads the rows of an element. It keeps the vertices, and the numbers of PCL's
 * camera element, which have the size of the cloud. */
void
readRows (PlyData& data,
          const PlyElement& element,
          pcl::PCLPointCloud2& points,
          std::map<std::string, double>& grid)
{
  const bool is_vertex = element.name == "vertex";
  std::uint8_t* point = points.data.data();
  data.beginElement();
  for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
    data.beginRow (element);
    for (const PlyProperty& property : element.properties) {
      const bool is_list = property.length_type != nullptr;
      if (is_vertex && !is_list && !property.becomes_float) {
        data.read (*property.type, point + property.offset);
        continue;
      }
      const double number = data.readProperty (property);
      const auto single = static_cast<float> (number);
      if (is_vertex && !is_list)
        std::memcpy (point + property.offset, &single, sizeof (single));
      else if (element.name == "camera")
        grid[property.name] = number;
    }
    data.endRow();
    point += is_vertex ? points.point_step : 0;
  }
}

void
organize (std::uint64_t size,
          std::map<std::string, double>& grid,
          pcl::PCLPointCloud2& points)
{
  const auto size_of = [&] (const char* of_camera, const char* of_info) {
    return grid.count (of_camera) > 0 ? grid[of_camera] : grid[of_info];
  };
  const double width = size_of ("viewportx", "num_cols");
  const double height = size_of ("viewporty", "num_rows");
  const bool fits = width * height == static_cast<double> (size) && width >= 1.0 &&
                    width == std::floor (width) && height == std::floor (height);
  points.width = static_cast<pcl::uindex_t> (fits ? width : static_cast<double> (size));
  points.height = static_cast<pcl::uindex_t> (fits ? height : 1.0);
}

/** \brief Whether the field is PCL's packed color. A text file may have a column of
 * this name that is not. */
bool
isColor (const PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         numberType (field.datatype).size == sizeof (std::uint32_t);
}

/** \brief Returns the properties red, green, blue (and alpha) of PCL's packed color,
 * whose lowest byte is blue. */
PlyProperties
colorProperties (const PCLPointField& field)
{
  const NumberType* const type = &numberType (PCLPointField::UINT8);
  PlyProperties properties;
  for (const pcl::uindex_t place : {2u, 1u, 0u, 3u})
    if (properties.size() < field.name.size()) // three or four letters: rgb, rgba
      properties.push_back (
          {color_names.at (place), type, nullptr, field.offset + place});
  return properties;
}

PlyProperties
numberProperties (const PCLPointField& field)
{
  PlyProperties properties;
  const NumberType& type = numberType (field.datatype);
  const bool is_normal =
      field.name == "normal_x" || field.name == "normal_y" || field.name == "normal_z";
  const std::string name = is_normal ? "n" + field.name.substr (7) : field.name;
  for (pcl::uindex_t i = 0; i < field.count; ++i)
    properties.push_back ({field.count == 1 ? name : name + "_" + std::to_string (i),
                           &type,
                           nullptr,
                           field.offset + static_cast<pcl::uindex_t> (i * type.size)});
  return properties;
}

/** \brief Returns the properties of a cloud. A name that is already taken gets a
 * further _; names of colors are never changed. */
PlyProperties
propertiesOf (const pcl::PCLPointCloud2& points)
{
  const auto& fields = points.fields;
  const auto color = std::find_if (fields.begin(), fields.end(), isColor);
  const PlyProperties colors =
      color == fields.end() ? PlyProperties() : colorProperties (*color);
  std::set<std::string> taken;
  for (const PlyProperty& property : colors)
    taken.insert (property.name);
  PlyProperties properties;
  for (auto field = fields.begin(); field != fields.end(); ++field)
    if (field == color)
      properties.insert (properties.end(), colors.begin(), colors.end());
    else if (!isColor (*field) && field->name != "_") // padding of a PCD
      for (PlyProperty& property : numberProperties (*field)) {
        while (!taken.insert (property.name).second)
          property.name += "_";
        properties.push_back (property);
      }
  return properties;
}

} // namespace

FileCloud
readPly (const std::string& file)
{
  HeaderReader reader (file, "PLY");
  PlyHeader header = readPlyHeader (reader);
  const bool is_text = header.format == "ascii";
  std::uint64_t min_bytes = 0;
  for (const PlyElement& element : header.elements)
    for (const PlyProperty& property : element.properties) {
      // A list may be empty. In text a number takes two bytes, with its separator.
      const NumberType* const binary =
          property.length_type == nullptr ? property.type : property.length_type;
      min_bytes += element.count * (is_text ? 2 : binary->size);
    }
  if (reader.fileSize() - reader.position() + 1 < min_bytes)
    reader.failTruncated();
  FileCloud cloud;
  PlyData data (reader, header.format);
  for (PlyElement& element : header.elements) {
    if (element.name == "vertex")
      addFields (element, cloud.points);
    readRows (data, element, cloud.points, header.grid);
  }
  if (is_text)
    reader.expectEnd();
  organize (header.find ("vertex")->count, header.grid, cloud.points);
  return cloud;
}

std::string
plyHeader (const pcl::PCLPointCloud2& points)
{
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  if (points.height > 1)
    header += "obj_info num_cols " + std::to_string (points.width) +
              "\nobj_info num_rows " + std::to_string (points.height) + "\n";
  header += "element vertex " + std::to_string (sizeOf (points)) + "\n";
  for (const PlyProperty& property : propertiesOf (points)) {
    const std::string_view type = property.type->ply_name;
    header += "property " + std::string (type.empty() ? "double" : type) + " " +
              property.name + "\n";
  }
  return header + "end_header\n";
}

std::string
plyVertices (const pcl::PCLPointCloud2& points)
{
  const PlyProperties properties = propertiesOf (points);
  std::string bytes;
  for (std::size_t i = 0; i < sizeOf (points); ++i)
    for (const PlyProperty& property : properties) {
      const NumberType& type = *property.type;
      const std::uint8_t* number =
          &points.data[i * points.point_step + property.offset];
      const double converted = type.ply_name.empty() ? type.read (number) : 0.0;
      if (type.ply_name.empty())
        number = reinterpret_cast<const std::uint8_t*> (&converted);
      bytes.append (reinterpret_cast<const char*> (number), type.size);
    }
  return bytes;
}

} // namespace pcl_ops::apps

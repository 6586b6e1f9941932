// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/endian/conversion.hpp>

#include "cloud_formats.h"
#include "file_reader.h"
#include "number_types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <set>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

/** \brief A property of an element. If the element is vertex, the property becomes a
 * field of the cloud, or a byte of its packed color. */
struct PlyProperty {
  std::string name;
  const NumberType* type = nullptr;
  /** \brief Type of the length in front of a list; nullptr if the property is no list.
   */
  const NumberType* length_type = nullptr;
  /** \brief Offset of the number in a point of the cloud [bytes]. */
  pcl::uindex_t offset = 0;
  /** \brief Whether the field is a float, though \ref type is another type. */
  bool becomes_float = false;

  bool
  isList () const
  {
    return length_type != nullptr;
  }
};
using PlyProperties = std::vector<PlyProperty>;

/** \brief What a PLY has many of, as vertices or faces: a table with a column for each
 * property. */
struct PlyElement {
  std::string name;
  /** \brief Number of rows, each with a value of every property. */
  std::uint64_t count = 0;
  PlyProperties properties;
  bool has_lists = false;
};

struct PlyHeader {
  /** \brief ascii, binary_little_endian or binary_big_endian. */
  std::string format;
  /** \brief In the order of the data. */
  std::vector<PlyElement> elements;
  /** \brief Numbers that may tell width and height of an organized cloud, by their
   * names: num_cols and num_rows of obj_info, and, once the data are read, all
   * properties of PCL's camera element. */
  std::map<std::string, double> size_numbers;

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

/** \brief Largest numbers of elements, and of properties of an element. Both are far
 * above those of any cloud, so that a broken header fails soon. */
constexpr std::size_t max_elements = 1000, max_properties = 10000;

/** \brief Adds the element that a line "element NAME COUNT" declares.
 * \param[in] words of the line */
void
readElement (const FileReader& reader, const Words& words, PlyHeader& header)
{
  if (words.size() != 3)
    reader.fail ("its line element is incomplete");
  if (header.elements.size() == max_elements)
    reader.fail ("it has more than " + std::to_string (max_elements) + " elements");
  if (header.find (words[1]) != nullptr)
    reader.fail ("it has the element " + words[1] + " twice");
  header.elements.push_back (
      {words[1], reader.parseCount ("element " + words[1], words[2]), {}});
}

/** \brief Adds the property that a line "property TYPE NAME" or "property list
 * LENGTH_TYPE TYPE NAME" declares to the last element.
 * \param[in] words of the line */
void
readProperty (const FileReader& reader, const Words& words, PlyHeader& header)
{
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (header.elements.empty() || (words.size() != 3 && !is_list))
    reader.fail ("its line property is incomplete");
  const auto type_called = [&] (const std::string& name) {
    const NumberType* const type = findNumberType ([&] (const NumberType& known) {
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
                                 type_called (words[words.size() - 2]),
                                 is_list ? type_called (words[2]) : nullptr});
  element.has_lists = element.has_lists || is_list;
}

/** \throws WorkError if the format is unknown, or there are no vertices, or two
 * properties of vertices have the same name */
void
checkHeader (const FileReader& reader, const PlyHeader& header)
{
  if (header.format != "ascii" && header.format != "binary_little_endian" &&
      header.format != "binary_big_endian")
    reader.fail ("its format is not ascii, binary_little_endian or binary_big_endian");
  const PlyElement* const vertex = header.find ("vertex");
  if (vertex == nullptr)
    reader.fail ("it has no element vertex");
  std::set<std::string> names;
  for (const PlyProperty& property : vertex->properties) {
    if (!property.isList() && !names.insert (property.name).second)
      reader.fail ("its vertices have " + property.name + " twice");
  }
  if (vertex->count == 0)
    reader.failEmpty();
}

PlyHeader
readPlyHeader (FileReader& reader)
{
  PlyHeader header;
  if (reader.nextHeaderLine ("ply") != Words{"ply"})
    reader.fail ("its first line is not ply");
  for (Words words; words != Words{"end_header"};) {
    words = reader.nextHeaderLine ("end_header");
    const std::string key = words.empty() ? "" : words[0];
    if (key == "format" && words.size() == 3)
      header.format = words[1];
    else if (key == "element")
      readElement (reader, words, header);
    else if (key == "property")
      readProperty (reader, words, header);
    else if (key == "obj_info" && words.size() > 2 &&
             (words[1] == "num_cols" || words[1] == "num_rows"))
      header.size_numbers[words[1]] =
          static_cast<double> (reader.parseCount (words[1], words[2]));
    else if (key != "obj_info" && key != "comment" && key != "end_header")
      reader.fail ("its line '" + key + "' is unknown or incomplete");
  }
  checkHeader (reader, header);
  return header;
}

/** \brief Reads the data of a PLY, number by number. */
class PlyData {
public:
  /** \param[in] format PlyHeader::format */
  PlyData (FileReader& reader, const std::string& format)
  : reader_ (reader), is_text_ (format == "ascii")
  {
    using boost::endian::order;
    is_swapped_ = (format == "binary_big_endian") != (order::native == order::big);
  }

  /** \brief Call it before the first row of each element. */
  void
  beginElement ()
  {
    line_lengths_.clear();
  }

  /** \brief Begins the next row. In a text this is the next line; or the next lines, if
   * the rows of an element without lists have several lines each. */
  void
  beginRow (const PlyElement& element)
  {
    next_word_ = 0;
    if (!is_text_)
      return;
    if (line_lengths_.size() > 1)
      return reader_.nextJoinedLines (line_lengths_);
    reader_.nextNumbers();
    if (element.has_lists)
      return;
    if (line_lengths_.empty())
      line_lengths_ = reader_.joinNextLines (element.properties.size());
    reader_.expectWordCount (element.properties.size());
  }

  /** \brief Reads the next number of the row, in the byte order of the machine. */
  void
  read (const NumberType& type, std::uint8_t* bytes)
  {
    if (is_text_)
      return reader_.readNumber (nextWord(), type, bytes);
    reader_.read (bytes, type.size);
    if (is_swapped_)
      std::reverse (bytes, bytes + type.size);
  }

  /** \brief Reads the value of a property of the row.
   * \return the number; of a list the last number, or 0 if the list is empty */
  double
  readValue (const PlyProperty& property)
  {
    const double count = property.isList() ? number (*property.length_type) : 1.0;
    if (!(count >= 0.0))
      failAtList();
    double last = 0.0;
    for (double i = 0.0; i < count; ++i)
      last = number (*property.type);
    return last;
  }

  /** \throws WorkError if numbers of the row have not been read */
  void
  endRow () const
  {
    if (is_text_ && next_word_ != reader_.wordCount())
      failAtList();
  }

private:
  /** \brief Reads the next number of the row. */
  double
  number (const NumberType& type)
  {
    if (is_text_)
      return reader_.number (nextWord());
    std::uint8_t bytes[sizeof (double)];
    read (type, bytes);
    return type.read (bytes);
  }

  /** \brief Returns the index of the next word of the line. */
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

  FileReader& reader_;
  /** \brief Whether the format is ascii, and whether the bytes of numbers are in the
   * reverse of the machine's order. */
  bool is_text_, is_swapped_ = false;
  /** \brief Index of the next word to read in the reader's current line. */
  std::size_t next_word_ = 0;
  /** \brief The number of words in each line of the first row of the element; empty
   * before this row and for elements with lists. */
  std::vector<std::size_t> line_lengths_;
};

/** \brief The names of the bytes of PCL's packed color, from the lowest byte to the
 * highest.
 */
constexpr std::array<const char*, 4> color_names = {"blue", "green", "red", "alpha"};

/** \brief Returns the index of the byte of PCL's packed color that a property becomes;
 * nothing if the property is no color of type uchar. */
std::optional<pcl::uindex_t>
byteInColor (const PlyProperty& property)
{
  for (pcl::uindex_t i = 0; i < color_names.size(); ++i)
    if (property.type->id == PCLPointField::UINT8 &&
        (property.name == color_names.at (i) ||
         property.name == std::string ("diffuse_") + color_names.at (i)))
      return i;
  return {};
}

/** \brief Adds the field that a property becomes which is no part of a color. */
void
addOwnField (PlyProperty& property, pcl::PCLPointCloud2& points)
{
  const std::string& name = property.name;
  const bool is_normal = name == "nx" || name == "ny" || name == "nz";
  const std::uint8_t datatype = property.type->id;
  property.becomes_float = name == "intensity" && datatype == PCLPointField::UINT8;
  property.offset = points.point_step;
  addField (is_normal ? "normal_" + name.substr (1) : name,
            property.becomes_float ? std::uint8_t (PCLPointField::FLOAT32) : datatype,
            points);
}

/** \brief Adds the fields of the vertices, with PCL's names and types for normals,
 * color and intensity, and makes room for the points. Lists are left out: a field has a
 * fixed number of values. */
void
addFields (PlyElement& vertex, pcl::PCLPointCloud2& points)
{
  std::optional<std::size_t> color_index; // of the color field in points.fields
  for (PlyProperty& property : vertex.properties) {
    if (property.isList())
      continue;
    const std::optional<pcl::uindex_t> byte = byteInColor (property);
    if (!byte) {
      addOwnField (property, points);
      continue;
    }
    if (!color_index) {
      color_index = points.fields.size();
      addField ("rgb", PCLPointField::FLOAT32, points);
    }
    PCLPointField& field = points.fields[*color_index];
    if (property.name == "alpha") {
      field.name = "rgba";
      field.datatype = PCLPointField::UINT32;
    }
    property.offset = field.offset + *byte;
  }
  points.data.resize (vertex.count * points.point_step);
}

/** \brief Reads the rows of an element. Keeps the vertices in \p points, and the
 * numbers of PCL's camera element, which tell the size of the cloud, in \p
 * size_numbers; skips other elements. */
void
readRows (PlyData& data,
          const PlyElement& element,
          pcl::PCLPointCloud2& points,
          std::map<std::string, double>& size_numbers)
{
  const bool is_vertex = element.name == "vertex";
  std::uint8_t* point = points.data.data(); // the vertex of the row
  data.beginElement();
  for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
    data.beginRow (element);
    for (const PlyProperty& property : element.properties) {
      const bool is_field = is_vertex && !property.isList();
      if (is_field && !property.becomes_float) {
        data.read (*property.type, point + property.offset);
        continue;
      }
      const double number = data.readValue (property);
      const auto single = static_cast<float> (number);
      if (is_field)
        std::memcpy (point + property.offset, &single, sizeof (single));
      else if (element.name == "camera")
        size_numbers[property.name] = number;
    }
    data.endRow();
    point += is_vertex ? points.point_step : 0;
  }
}

/** \brief Sets width and height of a cloud with \p size points to those that the camera
 * element tells, else to those of obj_info. If these do not fit the size, the cloud is
 * unorganized. */
void
organize (std::uint64_t size,
          std::map<std::string, double>& size_numbers,
          pcl::PCLPointCloud2& points)
{
  // Returns 0 if there is neither name.
  const auto number = [&] (const char* camera_name, const char* info_name) {
    return size_numbers.count (camera_name) > 0 ? size_numbers[camera_name]
                                                : size_numbers[info_name];
  };
  const double width = number ("viewportx", "num_cols");
  const double height = number ("viewporty", "num_rows");
  const bool are_whole = width == std::floor (width) && height == std::floor (height);
  const bool fits =
      are_whole && width >= 1.0 && width * height == static_cast<double> (size);
  points.width = static_cast<pcl::uindex_t> (fits ? width : static_cast<double> (size));
  points.height = static_cast<pcl::uindex_t> (fits ? height : 1.0);
}

/** \brief Whether the field is PCL's packed color. A column of a text file may have
 * this name, too, but is a double. */
bool
isColor (const PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         numberType (field.datatype).size == sizeof (std::uint32_t);
}

/** \brief Returns the properties red, green, blue (and alpha) of a field that is PCL's
 * packed color. */
PlyProperties
colorProperties (const PCLPointField& field)
{
  const NumberType* const type = &numberType (PCLPointField::UINT8);
  PlyProperties properties;
  for (const pcl::uindex_t byte : {2u, 1u, 0u, 3u}) // red, green, blue, alpha
    if (properties.size() < field.name.size())      // three or four letters: rgb, rgba
      properties.push_back (
          {color_names.at (byte), type, nullptr, field.offset + byte});
  return properties;
}

/** \brief Returns a property for each number of a field that is no color. */
PlyProperties
numberProperties (const PCLPointField& field)
{
  PlyProperties properties;
  const NumberType& type = numberType (field.datatype);
  const bool is_normal =
      field.name == "normal_x" || field.name == "normal_y" || field.name == "normal_z";
  const std::string name =
      is_normal ? std::string ("n") + field.name.back() : field.name;
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

/** \brief Returns the least number of bytes that the data of a PLY have. Of a list only
 * the length is counted, as it may be empty.
 * \param[in] is_text whether the format is ascii */
std::uint64_t
minDataSize (const PlyHeader& header, bool is_text)
{
  constexpr std::uint64_t min_text_size = 2; // [bytes], a digit and a separator
  std::uint64_t size = 0;
  for (const PlyElement& element : header.elements)
    for (const PlyProperty& property : element.properties) {
      const NumberType& first_number =
          property.isList() ? *property.length_type : *property.type;
      size += element.count * (is_text ? min_text_size : first_number.size);
    }
  return size;
}

} // namespace

FileCloud
readPly (const std::string& file)
{
  FileReader reader (file, "PLY");
  PlyHeader header = readPlyHeader (reader);
  const bool is_text = header.format == "ascii";
  // The separator behind the last number may be missing.
  if (reader.bytesLeft() + 1 < minDataSize (header, is_text))
    reader.failTruncated();
  FileCloud cloud;
  PlyData data (reader, header.format);
  for (PlyElement& element : header.elements) {
    if (element.name == "vertex")
      addFields (element, cloud.points);
    readRows (data, element, cloud.points, header.size_numbers);
  }
  if (is_text)
    reader.expectEnd();
  organize (header.find ("vertex")->count, header.size_numbers, cloud.points);
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
    const std::string_view type = property.type->ply_name; // empty: not in PLY
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
      const bool is_in_ply = !type.ply_name.empty();
      const double converted = is_in_ply ? 0.0 : type.read (number);
      if (!is_in_ply) // a 64-bit integer, which has the size of a double
        number = reinterpret_cast<const std::uint8_t*> (&converted);
      bytes.append (reinterpret_cast<const char*> (number), type.size);
    }
  return bytes;
}

} // namespace pcl_ops::apps

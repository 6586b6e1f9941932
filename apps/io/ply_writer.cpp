// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ply_writer.h"

#include <pcl/common/io.h>

#include "output_file.h"
#include "typed_number.h"

#include <array>
#include <cstring>
#include <ostream>
#include <set>
#include <vector>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

/** \brief A property of the vertices and where it is in a point. */
struct VertexProperty {
  std::string name;
  std::uint8_t type;
  pcl::uindex_t offset;
};

/** \return nullptr for 64-bit integers, which PLY has none of */
const char*
nameOfType (std::uint8_t type)
{
  switch (type) {
  case PCLPointField::INT8:
    return "char";
  case PCLPointField::UINT8:
    return "uchar";
  case PCLPointField::INT16:
    return "short";
  case PCLPointField::UINT16:
    return "ushort";
  case PCLPointField::INT32:
    return "int";
  case PCLPointField::UINT32:
    return "uint";
  case PCLPointField::FLOAT32:
    return "float";
  case PCLPointField::FLOAT64:
    return "double";
  default:
    return nullptr;
  }
}

/** \brief Whether it is PCL's packed colour, which a column of a text is not. */
bool
isColor (const PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         pcl::getFieldSize (field.datatype) == sizeof (std::uint32_t);
}

/** \brief The properties of PCL's packed colour, whose lowest byte is blue. */
std::vector<VertexProperty>
colorProperties (const PCLPointField& field)
{
  std::vector<VertexProperty> properties;
  const std::array<const char*, 4> names = {"red", "green", "blue", "alpha"};
  const std::array<pcl::uindex_t, 4> places = {2, 1, 0, 3};
  for (std::size_t i = 0; i < field.name.size(); ++i)
    properties.push_back ({names[i], PCLPointField::UINT8, field.offset + places[i]});
  return properties;
}

std::string
nameInPly (const std::string& field)
{
  const std::string normal = "normal_";
  return field.compare (0, normal.size(), normal) == 0 &&
                 field.size() == normal.size() + 1
             ? "n" + field.substr (normal.size())
             : field;
}

std::vector<VertexProperty>
numberProperties (const PCLPointField& field)
{
  std::vector<VertexProperty> properties;
  const std::string name = nameInPly (field.name);
  const auto size = static_cast<pcl::uindex_t> (pcl::getFieldSize (field.datatype));
  for (pcl::uindex_t i = 0; i < field.count; ++i)
    properties.push_back ({field.count == 1 ? name : name + "_" + std::to_string (i),
                           field.datatype,
                           field.offset + i * size});
  return properties;
}

/** \brief Those of a cloud. A name that another has, colours before all, gets a _ more.
 */
std::vector<VertexProperty>
propertiesOf (const pcl::PCLPointCloud2& points)
{
  std::set<std::string> taken;
  const PCLPointField* color = nullptr;
  for (const PCLPointField& field : points.fields)
    if (color == nullptr && isColor (field)) {
      color = &field;
      for (const VertexProperty& property : colorProperties (field))
        taken.insert (property.name);
    }
  std::vector<VertexProperty> properties;
  for (const PCLPointField& field : points.fields) {
    if (&field == color)
      for (const VertexProperty& property : colorProperties (field))
        properties.push_back (property);
    else if (!isColor (field) && field.name != "_") // bytes that are nothing in PCD
      for (VertexProperty& property : numberProperties (field)) {
        while (!taken.insert (property.name).second)
          property.name += "_";
        properties.push_back (property);
      }
  }
  return properties;
}

std::string
plyHeader (const pcl::PCLPointCloud2& points,
           const std::vector<VertexProperty>& properties)
{
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  if (points.height > 1)
    header += "obj_info num_cols " + std::to_string (points.width) +
              "\nobj_info num_rows " + std::to_string (points.height) + "\n";
  header += "element vertex " +
            std::to_string (static_cast<std::uint64_t> (points.width) * points.height) +
            "\n";
  for (const VertexProperty& property : properties) {
    const char* const type = nameOfType (property.type);
    header += std::string ("property ") + (type == nullptr ? "double" : type) + " " +
              property.name + "\n";
  }
  return header + "end_header\n";
}

void
appendNumber (const std::uint8_t* point,
              const VertexProperty& property,
              std::string& bytes)
{
  const std::uint8_t* const number = point + property.offset;
  if (nameOfType (property.type) != nullptr) {
    bytes.append (reinterpret_cast<const char*> (number),
                  static_cast<std::size_t> (pcl::getFieldSize (property.type)));
    return;
  }
  const double converted = readerOf (property.type) (number);
  bytes.append (reinterpret_cast<const char*> (&converted), sizeof (converted));
}

} // namespace

void
savePly (const std::string& file, const FileCloud& cloud)
{
  constexpr std::size_t block = 1U << 16U;
  const std::vector<VertexProperty> properties = propertiesOf (cloud.points);
  writeFile (file, [&] (std::ostream& stream) {
    std::string bytes = plyHeader (cloud.points, properties);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      for (const VertexProperty& property : properties)
        appendNumber (
            cloud.points.data.data() + i * cloud.points.point_step, property, bytes);
      if (bytes.size() < block)
        continue;
      stream << bytes;
      bytes.clear();
    }
    stream << bytes;
  });
}

} // namespace pcl_ops::apps

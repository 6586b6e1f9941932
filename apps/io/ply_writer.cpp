// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ply_writer.h"

#include "cloud_fields.h"
#include "number_types.h"

#include <array>
#include <set>
#include <string>
#include <vector>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

struct VertexProperty {
  std::string name;
  const NumberType* type;
  pcl::uindex_t offset;
};
using VertexProperties = std::vector<VertexProperty>;

/** \brief Whether it is PCL's packed color, which a column of a text is not. */
bool
isColor (const PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         numberType (field.datatype).size == sizeof (std::uint32_t);
}

/** \brief The properties of PCL's packed color, whose lowest byte is blue. */
VertexProperties
colorProperties (const PCLPointField& field)
{
  VertexProperties properties;
  const std::array<const char*, 4> names = {"red", "green", "blue", "alpha"};
  const std::array<pcl::uindex_t, 4> places = {2, 1, 0, 3};
  for (std::size_t i = 0; i < field.name.size(); ++i)
    properties.push_back (
        {names[i], &numberType (PCLPointField::UINT8), field.offset + places[i]});
  return properties;
}

VertexProperties
numberProperties (const PCLPointField& field)
{
  VertexProperties properties;
  const NumberType& type = numberType (field.datatype);
  const bool is_normal =
      field.name == "normal_x" || field.name == "normal_y" || field.name == "normal_z";
  const std::string name = is_normal ? "n" + field.name.substr (7) : field.name;
  for (pcl::uindex_t i = 0; i < field.count; ++i)
    properties.push_back ({field.count == 1 ? name : name + "_" + std::to_string (i),
                           &type,
                           field.offset + static_cast<pcl::uindex_t> (i * type.size)});
  return properties;
}

/** \brief Those of a cloud. A name that another has, colors before all, gets a _ more.
 */
VertexProperties
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
  VertexProperties properties;
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

void
appendNumber (const std::uint8_t* point,
              const VertexProperty& property,
              std::string& bytes)
{
  const NumberType& type = *property.type;
  const std::uint8_t* const number = point + property.offset;
  if (!type.ply_name.empty()) {
    bytes.append (reinterpret_cast<const char*> (number), type.size);
    return;
  }
  const double converted = type.read (number);
  bytes.append (reinterpret_cast<const char*> (&converted), sizeof (converted));
}

} // namespace

std::string
plyHeader (const pcl::PCLPointCloud2& points)
{
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  if (points.height > 1)
    header += "obj_info num_cols " + std::to_string (points.width) +
              "\nobj_info num_rows " + std::to_string (points.height) + "\n";
  header += "element vertex " + std::to_string (sizeOf (points)) + "\n";
  for (const VertexProperty& property : propertiesOf (points)) {
    const std::string_view type = property.type->ply_name;
    header += "property " + std::string (type.empty() ? "double" : type) + " " +
              property.name + "\n";
  }
  return header + "end_header\n";
}

std::string
plyVertices (const pcl::PCLPointCloud2& points)
{
  const VertexProperties properties = propertiesOf (points);
  std::string bytes;
  for (std::size_t i = 0; i < sizeOf (points); ++i)
    for (const VertexProperty& property : properties)
      appendNumber (points.data.data() + i * points.point_step, property, bytes);
  return bytes;
}

} // namespace pcl_ops::apps

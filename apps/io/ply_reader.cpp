// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ply_reader.h"

#include <boost/endian/conversion.hpp>

#include "cloud_fields.h"
#include "header_reader.h"
#include "ply_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <vector>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

/** \brief The data of a PLY, number by number. */
class PlyData {
public:
  PlyData (HeaderReader& reader, const PlyHeader& header)
  : reader_ (reader), lines_ (reader), is_text_ (header.format == "ascii")
  {
    using boost::endian::order;
    const bool is_big = header.format == "binary_big_endian";
    is_swapped_ = is_big != (order::native == order::big);
  }

  void
  beginRow (const PlyElement& element)
  {
    next_word_ = 0;
    if (!is_text_)
      return;
    lines_.next();
    const bool has_lists = std::any_of (
        element.properties.begin(),
        element.properties.end(),
        [] (const auto& property) { return property.length_type != nullptr; });
    if (!has_lists)
      lines_.expectNumbers (element.properties.size());
  }

  void
  read (const NumberType& type, std::uint8_t* bytes)
  {
    if (is_text_)
      return lines_.read (nextWord(), type, bytes);
    reader_.read (reinterpret_cast<char*> (bytes), type.size);
    if (is_swapped_)
      std::reverse (bytes, bytes + type.size);
  }

  double
  number (const NumberType& type)
  {
    if (is_text_)
      return lines_.number (nextWord());
    std::uint8_t bytes[sizeof (double)];
    read (type, bytes);
    return type.read (bytes);
  }

  /** \brief A number, or those of a list. */
  void
  readProperty (const PlyProperty& property, std::vector<double>& numbers)
  {
    const double count =
        property.length_type == nullptr ? 1.0 : number (*property.length_type);
    if (!(count >= 0.0))
      failAtList();
    numbers.clear();
    for (double i = 0.0; i < count; ++i)
      numbers.push_back (number (*property.type));
  }

  void
  endRow () const
  {
    if (is_text_ && next_word_ != lines_.size())
      failAtList();
  }

  void
  end ()
  {
    if (is_text_)
      lines_.expectEnd();
  }

private:
  std::size_t
  nextWord ()
  {
    if (next_word_ == lines_.size())
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
  NumberLines lines_;
  bool is_text_, is_swapped_ = false;
  std::size_t next_word_ = 0;
};

/** \brief Where a number of a vertex goes to in a point, in bytes. */
struct Target {
  const NumberType* type;
  pcl::uindex_t offset;
  bool becomes_float;
};

/** \brief Of a color that is one byte: its place in PCL's packed one, or -1. */
int
placeInColor (const PlyProperty& property)
{
  const std::array<std::string, 4> names = {"blue", "green", "red", "alpha"};
  if (property.type->id != PCLPointField::UINT8)
    return -1;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (property.name == names[i] || property.name == "diffuse_" + names[i])
      return static_cast<int> (i);
  return -1;
}

/** \brief As PCL names fields: normals, and the intensity as a float. */
Target
addProperty (const PlyProperty& property, pcl::PCLPointCloud2& points)
{
  const NumberType& float_type = numberType (PCLPointField::FLOAT32);
  const std::string& name = property.name;
  const bool is_normal = name == "nx" || name == "ny" || name == "nz";
  const bool becomes_float =
      name == "intensity" && property.type->id == PCLPointField::UINT8;
  const Target target{property.type, points.point_step, becomes_float};
  addField (is_normal ? "normal_" + name.substr (1) : name,
            becomes_float ? float_type : *property.type,
            1,
            points);
  return target;
}

std::vector<Target>
addFields (const PlyElement& vertex, pcl::PCLPointCloud2& points)
{
  std::vector<Target> targets;
  std::size_t color = 0; // one after its index
  for (const PlyProperty& property : vertex.properties) {
    const int place = placeInColor (property);
    if (place < 0) {
      targets.push_back (addProperty (property, points));
      continue;
    }
    if (color == 0) {
      addField ("rgb", numberType (PCLPointField::FLOAT32), 1, points);
      color = points.fields.size();
    }
    PCLPointField& field = points.fields[color - 1];
    if (property.name == "alpha") {
      field.name = "rgba";
      field.datatype = PCLPointField::UINT32;
    }
    targets.push_back (
        {property.type, field.offset + static_cast<pcl::uindex_t> (place), false});
  }
  return targets;
}

void
readVertices (PlyData& data, const PlyElement& vertex, pcl::PCLPointCloud2& points)
{
  const std::vector<Target> targets = addFields (vertex, points);
  points.data.resize (vertex.count * points.point_step);
  for (std::uint64_t i = 0; i < vertex.count && !targets.empty(); ++i) {
    std::uint8_t* const point = points.data.data() + i * points.point_step;
    data.beginRow (vertex);
    for (const Target& target : targets)
      if (target.becomes_float) {
        const auto number = static_cast<float> (data.number (*target.type));
        std::memcpy (point + target.offset, &number, sizeof (number));
      }
      else
        data.read (*target.type, point + target.offset);
  }
}

/** \brief Skips an element, except for what PCL's camera says about the cloud. */
void
readOther (PlyData& data,
           const PlyElement& element,
           std::map<std::string, double>& grid)
{
  const std::map<std::string, std::string> sizes = {{"viewportx", "num_cols"},
                                                    {"viewporty", "num_rows"}};
  std::vector<double> numbers;
  for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
    data.beginRow (element);
    for (const PlyProperty& property : element.properties) {
      data.readProperty (property, numbers);
      const auto size = sizes.find (property.name);
      if (element.name == "camera" && size != sizes.end() && !numbers.empty())
        grid[size->second] = numbers[0];
    }
    data.endRow();
  }
}

void
organize (std::uint64_t size,
          std::map<std::string, double>& grid,
          pcl::PCLPointCloud2& points)
{
  const double width = grid["num_cols"], height = grid["num_rows"];
  const bool fits = width * height == static_cast<double> (size) && width >= 1.0 &&
                    width == std::floor (width) && height == std::floor (height);
  points.width = static_cast<pcl::uindex_t> (fits ? width : static_cast<double> (size));
  points.height = static_cast<pcl::uindex_t> (fits ? height : 1.0);
  points.row_step = points.point_step * points.width;
}

/** \brief Fewest bytes of a row: lists may be empty, a number that is text is a digit
 * and a separator. */
std::uint64_t
minSize (const PlyElement& element, bool is_text)
{
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes += is_text ? 2
                     : (property.length_type == nullptr ? property.type->size
                                                        : property.length_type->size);
  return bytes;
}

} // namespace

FileCloud
readPly (const std::string& file)
{
  HeaderReader reader (file, "PLY");
  PlyHeader header = readPlyHeader (reader);
  std::uint64_t bytes = 0;
  for (const PlyElement& element : header.elements)
    bytes += element.count * minSize (element, header.format == "ascii");
  if (reader.fileSize() - reader.position() + 1 < bytes)
    reader.failTruncated();
  FileCloud cloud;
  PlyData data (reader, header);
  for (const PlyElement& element : header.elements)
    if (element.name == "vertex")
      readVertices (data, element, cloud.points);
    else
      readOther (data, element, header.grid);
  data.end();
  organize (header.find ("vertex")->count, header.grid, cloud.points);
  return cloud;
}

} // namespace pcl_ops::apps

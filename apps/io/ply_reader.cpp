// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ply_reader.h"

#include <boost/endian/conversion.hpp>

#include "cloud_fields.h"
#include "number_lines.h"
#include "ply_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
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
  for (std::uint64_t i = 0; i < vertex.count; ++i) {
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

/** \brief What other elements say about the order of the vertices. */
struct Order {
  /** \brief Of each cell of a range_grid a vertex or, where it has none, -1. */
  std::vector<std::int64_t> cells;
  /** \brief As PCL writes it with a camera. */
  double width = 0.0, height = 0.0;
};

void
readOther (PlyData& data,
           const PlyElement& element,
           const PlyHeader& header,
           const HeaderReader& reader,
           Order& order)
{
  const auto vertices = static_cast<double> (header.find ("vertex")->count);
  const bool is_grid = element.name == "range_grid",
             is_camera = element.name == "camera";
  std::vector<double> numbers;
  for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
    data.beginRow (element);
    if (is_grid)
      order.cells.push_back (-1);
    for (const PlyProperty& property : element.properties) {
      data.readProperty (property, numbers);
      const bool is_cell = is_grid && property.length_type != nullptr;
      for (const double vertex : numbers)
        if (is_cell && !(vertex >= 0.0 && vertex < vertices))
          reader.fail ("its range_grid names a vertex that does not exist");
      if (is_cell && !numbers.empty())
        order.cells.back() = static_cast<std::int64_t> (numbers[0]);
      if (is_camera && property.name == "viewportx" && !numbers.empty())
        order.width = numbers[0];
      if (is_camera && property.name == "viewporty" && !numbers.empty())
        order.height = numbers[0];
    }
    data.endRow();
  }
}

/** \brief A point without coordinates. */
std::vector<std::uint8_t>
emptyPoint (const pcl::PCLPointCloud2& points)
{
  std::vector<std::uint8_t> bytes (points.point_step);
  for (const PCLPointField& field : points.fields)
    if (field.datatype == PCLPointField::FLOAT32 ||
        field.datatype == PCLPointField::FLOAT64)
      numberType (field.datatype).parse ("nan", &bytes[field.offset]);
  return bytes;
}

void
organize (const PlyHeader& header, const Order& order, pcl::PCLPointCloud2& points)
{
  const std::uint64_t vertices = header.find ("vertex")->count;
  if (!order.cells.empty() && order.cells.size() != vertices) {
    const std::vector<std::uint8_t> empty = emptyPoint (points), data = points.data;
    points.data.clear();
    for (const std::int64_t cell : order.cells) {
      const std::uint8_t* const from =
          cell < 0 ? empty.data() : &data[std::size_t (cell) * points.point_step];
      points.data.insert (points.data.end(), from, from + points.point_step);
    }
  }
  const std::uint64_t size = points.data.size() / points.point_step;
  points.width = static_cast<pcl::uindex_t> (size);
  points.height = 1;
  if (!header.grid.empty()) {
    points.width = static_cast<pcl::uindex_t> (header.grid.at ("num_cols"));
    points.height = static_cast<pcl::uindex_t> (header.grid.at ("num_rows"));
  }
  else if (order.width >= 1.0 && order.height >= 1.0 &&
           order.width * order.height == static_cast<double> (size)) {
    points.width = static_cast<pcl::uindex_t> (order.width);
    points.height = static_cast<pcl::uindex_t> (order.height);
  }
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

/** \brief Refuses what would take more memory than such a file is worth. */
void
checkSize (HeaderReader& reader, const PlyHeader& header)
{
  constexpr std::uint64_t max_expansion = 100;
  const PlyElement& vertex = *header.find ("vertex");
  const PlyElement* const range_grid = header.find ("range_grid");
  const std::uint64_t cells = range_grid == nullptr ? vertex.count : range_grid->count;
  std::uint64_t bytes = 0;
  for (const PlyElement& element : header.elements)
    bytes += element.count * minSize (element, header.format == "ascii");
  if (reader.fileSize() - reader.position() + 1 < bytes ||
      cells * minSize (vertex, false) > max_expansion * reader.fileSize())
    reader.failTruncated();
  if (!header.grid.empty() &&
      (header.grid.size() != 2 || vertex.count > cells ||
       header.grid.at ("num_cols") * header.grid.at ("num_rows") != cells))
    reader.fail ("num_cols times num_rows is not its number of points");
}

} // namespace

FileCloud
readPly (const std::string& file)
{
  HeaderReader reader (file, "PLY");
  const PlyHeader header = readPlyHeader (reader);
  checkSize (reader, header);
  FileCloud cloud;
  PlyData data (reader, header);
  Order order;
  for (const PlyElement& element : header.elements)
    if (element.name == "vertex")
      readVertices (data, element, cloud.points);
    else
      readOther (data, element, header, reader, order);
  data.end();
  if (cloud.points.point_step > 0)
    organize (header, order, cloud.points);
  cloud.points.row_step = cloud.points.point_step * cloud.points.width;
  return cloud;
}

} // namespace pcl_ops::apps

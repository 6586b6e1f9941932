// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_fields.h"

#include <pcl/common/io.h>

#include <algorithm>
#include <cstring>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

/** \brief A field of the output and where its bytes come from in the input. */
struct Column {
  PCLPointField field;
  pcl::uindex_t source = 0;
  pcl::uindex_t size = 0;
  bool is_new = false;
};

/** \brief The fields of a cloud, each up to where the next one starts: that way also
 * types the installed PCL does not know are copied whole. */
std::vector<Column>
columnsOf (const pcl::PCLPointCloud2& cloud)
{
  std::vector<Column> columns;
  for (std::size_t i = 0; i < cloud.fields.size(); ++i) {
    const bool is_last = i + 1 == cloud.fields.size();
    const pcl::uindex_t start = cloud.fields[i].offset;
    const pcl::uindex_t end = is_last ? cloud.point_step : cloud.fields[i + 1].offset;
    columns.push_back ({cloud.fields[i], start, end - start, false});
  }
  return columns;
}

/** \brief Puts a new column in place of one of its name, else before the one called
 * \p before, else at the end. */
void
place (const Column& column, const std::string& before, std::vector<Column>& columns)
{
  const auto named = [&] (const std::string& name) {
    return std::find_if (columns.begin(), columns.end(), [&] (const Column& other) {
      return other.field.name == name;
    });
  };
  const auto old = named (column.field.name);
  if (old != columns.end())
    *old = column;
  else
    columns.insert (named (before), column);
}

/** \brief Sets one field of four bytes of every point and copies all others. */
void
setField (pcl::PCLPointCloud2& cloud,
          const std::string& name,
          std::uint8_t datatype,
          const std::string& before,
          const std::vector<std::uint32_t>& values)
{
  Column added{{}, 0, sizeof (values[0]), true};
  added.field.name = name;
  added.field.datatype = datatype;
  added.field.count = 1;
  std::vector<Column> columns = columnsOf (cloud);
  place (added, before, columns);

  pcl::uindex_t step = 0;
  cloud.fields.clear();
  for (Column& column : columns) {
    column.field.offset = step;
    step += column.size;
    cloud.fields.push_back (column.field);
  }
  std::vector<std::uint8_t> bytes (values.size() * step);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::uint8_t* const point = cloud.data.data() + i * cloud.point_step;
    const auto* const value = reinterpret_cast<const std::uint8_t*> (&values[i]);
    for (const Column& column : columns)
      std::copy_n (column.is_new ? value : point + column.source,
                   column.size,
                   bytes.data() + i * step + column.field.offset);
  }
  cloud.data = std::move (bytes);
  cloud.point_step = step;
  cloud.row_step = step * cloud.width;
}

} // namespace

void
addField (const std::string& name,
          const NumberType& type,
          pcl::uindex_t count,
          pcl::PCLPointCloud2& points)
{
  PCLPointField field;
  field.name = name;
  field.offset = points.point_step;
  field.datatype = type.id;
  field.count = count;
  points.fields.push_back (field);
  points.point_step += static_cast<pcl::uindex_t> (count * type.size);
}

bool
hasField (const FileCloud& cloud, const std::string& name)
{
  return pcl::getFieldIndex (cloud.points, name) >= 0;
}

void
setLabels (FileCloud& cloud, const std::vector<std::uint32_t>& labels)
{
  setField (cloud.points, "label", PCLPointField::UINT32, "", labels);
}

void
setDistances (FileCloud& cloud, const std::vector<float>& distances)
{
  std::vector<std::uint32_t> bits (distances.size());
  static_assert (sizeof (bits[0]) == sizeof (distances[0]));
  std::memcpy (bits.data(), distances.data(), bits.size() * sizeof (bits[0]));
  setField (cloud.points, "distance", PCLPointField::FLOAT32, "", bits);
}

void
setColors (FileCloud& cloud, const std::vector<pcl::RGB>& colors)
{
  std::vector<std::uint32_t> packed;
  packed.reserve (colors.size());
  for (const pcl::RGB& color : colors)
    packed.push_back (color.rgba);
  setField (cloud.points, "rgb", PCLPointField::FLOAT32, "rgba", packed);
}

} // namespace pcl_ops::apps

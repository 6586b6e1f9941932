// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_fields.h"

#include <pcl/common/io.h>

#include <algorithm>
#include <cstring>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

/** \brief Sets a field of four bytes of every point: in place of the one of its name,
 * which reaches to the next one, else before the one called \p before, else at the end.
 */
void
setField (pcl::PCLPointCloud2& cloud,
          const std::string& name,
          std::uint8_t datatype,
          const std::string& before,
          const std::vector<std::uint32_t>& values)
{
  constexpr pcl::uindex_t size = sizeof (values[0]);
  const int known = pcl::getFieldIndex (cloud, name);
  const int next = known < 0 ? pcl::getFieldIndex (cloud, before) : known;
  const std::size_t place =
      next < 0 ? cloud.fields.size() : static_cast<std::size_t> (next);
  const auto start_of = [&] (std::size_t field) {
    return field < cloud.fields.size() ? cloud.fields[field].offset : cloud.point_step;
  };
  const pcl::uindex_t begin = start_of (place);
  const pcl::uindex_t end = known < 0 ? begin : start_of (place + 1);
  const pcl::uindex_t step = cloud.point_step - (end - begin) + size;

  std::vector<std::uint8_t> bytes (values.size() * step);
  std::uint8_t* out = bytes.data();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::uint8_t* const point = cloud.data.data() + i * cloud.point_step;
    out = std::copy_n (point, begin, out);
    out = std::copy_n (reinterpret_cast<const std::uint8_t*> (&values[i]), size, out);
    out = std::copy (point + end, point + cloud.point_step, out);
  }
  if (known < 0)
    cloud.fields.insert (cloud.fields.begin() + static_cast<std::ptrdiff_t> (place),
                         PCLPointField());
  PCLPointField& field = cloud.fields[place];
  field.name = name;
  field.offset = begin;
  field.datatype = datatype;
  field.count = 1;
  for (std::size_t i = place + 1; i < cloud.fields.size(); ++i)
    cloud.fields[i].offset = begin + size + (cloud.fields[i].offset - end);
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
  for (std::size_t i = 0; i < bits.size(); ++i)
    std::memcpy (&bits[i], &distances[i], sizeof (bits[i]));
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

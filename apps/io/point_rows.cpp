// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "point_rows.h"

#include <pcl/PCLPointField.h>
#include <pcl/types.h>

#include "cloud_file.h"

#include <limits>

namespace pcl_ops::apps {

void
PointRows::addColumn (const std::string& name, std::uint8_t datatype)
{
  columns_.push_back ({is_skipped_.size(), &numberType (datatype), cloud.point_step});
  is_skipped_.push_back (false);
  addField (name, datatype, cloud);
}

void
PointRows::addColor()
{
  const pcl::uindex_t offset = cloud.point_step;
  addField ("rgb", pcl::PCLPointField::FLOAT32, cloud);
  // In PCL's packed color blue is the lowest byte, red the third one.
  constexpr pcl::uindex_t red = 2, green = 1, blue = 0;
  for (const pcl::uindex_t byte : {red, green, blue}) {
    columns_.push_back (
        {is_skipped_.size(), &numberType (pcl::PCLPointField::UINT8), offset + byte});
    is_skipped_.push_back (false);
  }
}

void
PointRows::skipColumn()
{
  is_skipped_.push_back (true);
}

void
PointRows::addColumnsOfLine (const Words& names_behind_z)
{
  const std::size_t count = reader_.wordCount();
  reader_.checkColumnCount();
  Words names = {"x", "y", "z"};
  if (names_behind_z.size() + names.size() == count)
    names.insert (names.end(), names_behind_z.begin(), names_behind_z.end());
  while (names.size() < count)
    names.push_back ("field_" + std::to_string (names.size() + 1));
  for (const std::string& name : names)
    addColumn (name, pcl::PCLPointField::FLOAT64);
}

void
PointRows::addPoint()
{
  constexpr auto max_points = std::numeric_limits<pcl::index_t>::max();
  reader_.expectWordCount (is_skipped_.size(), is_skipped_);
  if (size_ == static_cast<std::size_t> (max_points))
    reader_.fail ("it has more points than an index can tell apart");
  cloud.data.resize (cloud.data.size() + cloud.point_step);
  ++size_;
  for (const Column& column : columns_)
    reader_.readNumber (column.word, *column.type, lastPoint() + column.offset);
}

pcl::PCLPointCloud2
PointRows::take()
{
  if (size_ == 0)
    reader_.failEmpty();
  cloud.width = static_cast<pcl::uindex_t> (size_);
  cloud.height = 1;
  return std::move (cloud);
}

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "coordinate_reader.h"

#include <pcl/common/io.h>

#include <stdexcept>
#include <string>

namespace pcl_ops::apps {

namespace {

const pcl::PCLPointField&
fieldOf (const FileCloud& cloud, const std::string& name)
{
  const int index = pcl::getFieldIndex (cloud.points, name);
  if (index < 0)
    throw std::invalid_argument ("the cloud has no field " + name);
  return cloud.points.fields[static_cast<std::size_t> (index)];
}

} // namespace

CoordinateReader::CoordinateReader (const FileCloud& cloud) : cloud_ (cloud.points)
{
  for (std::size_t i = 0; i < 3; ++i) {
    const pcl::PCLPointField field = fieldOf (cloud, std::string (1, "xyz"[i]));
    offsets_[i] = field.offset;
    readers_[i] = readerOf (field.datatype);
    is_single_ = is_single_ && field.datatype == pcl::PCLPointField::FLOAT32;
  }
}

} // namespace pcl_ops::apps

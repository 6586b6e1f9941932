// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/io.h>
#include <pcl/point_types.h>

#include "cloud_file.h"

#include <cstdint>
#include <cstring>
#include <string>

namespace pcl_ops::apps {

/** \brief Writes a binary PCD without the padding of pcl::PointXYZL.
 * \throws WorkError if it cannot be written */
inline void
saveLabeledPcd (const std::string& file, const pcl::PointCloud<pcl::PointXYZL>& cloud)
{
  constexpr pcl::uindex_t bytes_of_number = 4; // float and std::uint32_t
  FileCloud packed{{}, cloud.sensor_origin_, cloud.sensor_orientation_};
  pcl::PCLPointCloud2& points = packed.points;
  points.width = cloud.width;
  points.height = cloud.height;
  points.is_dense = cloud.is_dense;
  points.fields = pcl::getFields<pcl::PointXYZL>();
  for (auto& field : points.fields) {
    field.offset = points.point_step;
    points.point_step += bytes_of_number;
  }
  points.row_step = points.point_step * points.width;
  points.data.resize (std::size_t (points.point_step) * cloud.size());
  std::uint8_t* bytes = points.data.data();
  for (const pcl::PointXYZL& point : cloud) {
    std::memcpy (bytes, point.data, 3 * bytes_of_number);
    std::memcpy (bytes + 3 * bytes_of_number, &point.label, bytes_of_number);
    bytes += points.point_step;
  }
  saveCloud (file, packed);
}

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "cloud_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Writes a binary PCD without the padding of pcl::PointXYZL.
 * \throws WorkError if it cannot be written */
inline void
saveLabeledPcd (const std::string& file, const pcl::PointCloud<pcl::PointXYZL>& cloud)
{
  FileCloud packed{{}, cloud.sensor_origin_, cloud.sensor_orientation_};
  pcl::PCLPointCloud2& points = packed.points;
  for (const char* axis : {"x", "y", "z"})
    addField (axis, pcl::PCLPointField::FLOAT32, points);
  points.width = cloud.width;
  points.height = cloud.height;
  std::vector<std::uint32_t> labels;
  for (const pcl::PointXYZL& point : cloud) {
    const auto* const bytes = reinterpret_cast<const std::uint8_t*> (point.data);
    points.data.insert (points.data.end(), bytes, bytes + points.point_step);
    labels.push_back (point.label);
  }
  setField (packed, "label", pcl::PCLPointField::UINT32, labels.data());
  saveCloud (file, packed);
}

} // namespace pcl_ops::apps

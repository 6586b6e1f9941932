// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "cloud_file.h"

#include <cstdint>
#include <string>

namespace pcl_ops::apps {

/** \brief Writes a binary PCD without the padding of pcl::PointXYZL. */
inline void
saveLabeledPcd (const std::string& file, const pcl::PointCloud<pcl::PointXYZL>& cloud)
{
  FileCloud packed{{}, cloud.sensor_origin_, cloud.sensor_orientation_};
  pcl::PCLPointCloud2& points = packed.points;
  for (const char* axis : {"x", "y", "z"})
    addField (axis, pcl::PCLPointField::FLOAT32, points);
  addField ("label", pcl::PCLPointField::UINT32, points);
  points.width = cloud.width;
  points.height = cloud.height;
  for (const pcl::PointXYZL& point : cloud) {
    const auto* const place = reinterpret_cast<const std::uint8_t*> (point.data);
    const auto* const label = reinterpret_cast<const std::uint8_t*> (&point.label);
    points.data.insert (points.data.end(), place, place + 3 * sizeof (float));
    points.data.insert (points.data.end(), label, label + sizeof (point.label));
  }
  saveCloud (file, packed);
}

} // namespace pcl_ops::apps

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

/** \brief Writes a binary PCD with x, y, z and label, without the padding of
 * pcl::PointXYZL.
 * \param[in] is_ignored for each point, whether its true label is unknown (1) or not
 * (0): the field `ignore`. If empty, the file has no such field. */
inline void
saveLabeledPcd (const std::string& file,
                const pcl::PointCloud<pcl::PointXYZL>& cloud,
                const std::vector<char>& is_ignored = {})
{
  FileCloud packed{{},
                   cloud.sensor_origin_.head<3>().cast<double>(),
                   cloud.sensor_orientation_.cast<double>()};
  pcl::PCLPointCloud2& points = packed.points;
  for (const char* coordinate : {"x", "y", "z"})
    addField (coordinate, pcl::PCLPointField::FLOAT32, points);
  addField ("label", pcl::PCLPointField::UINT32, points);
  if (!is_ignored.empty())
    addField ("ignore", pcl::PCLPointField::UINT8, points);
  points.width = cloud.width;
  points.height = cloud.height;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const pcl::PointXYZL& point = cloud[i];
    const auto* const xyz = reinterpret_cast<const std::uint8_t*> (point.data);
    const auto* const label = reinterpret_cast<const std::uint8_t*> (&point.label);
    points.data.insert (points.data.end(), xyz, xyz + 3 * sizeof (float));
    points.data.insert (points.data.end(), label, label + sizeof (point.label));
    if (!is_ignored.empty())
      points.data.push_back (std::uint8_t (is_ignored[i]));
  }
  saveCloud (file, packed);
}

} // namespace pcl_ops::apps

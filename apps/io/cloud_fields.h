// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>

#include "cloud_file.h"
#include "number_types.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief The number of points. */
inline std::size_t
sizeOf (const pcl::PCLPointCloud2& points)
{
  return static_cast<std::size_t> (points.width) * points.height;
}

/** \brief Declares a field behind those that a point has. */
void
addField (const std::string& name,
          const NumberType& type,
          pcl::uindex_t count,
          pcl::PCLPointCloud2& points);

/** \brief Whether the cloud has a field of that name. */
bool
hasField (const FileCloud& cloud, const std::string& name);

/** \brief Gives every point a field `label` (uint32), in place of one it had. */
void
setLabels (FileCloud& cloud, const std::vector<std::uint32_t>& labels);

/** \brief Gives every point a field `distance` (float), in place of one it had. */
void
setDistances (FileCloud& cloud, const std::vector<float>& distances);

/** \brief Gives every point a field `rgb` (PCL's packed float), in place of one it had.
 * A field `rgba` stays, and `rgb` comes before it, where PCL's point types look first.
 */
void
setColors (FileCloud& cloud, const std::vector<pcl::RGB>& colors);

} // namespace pcl_ops::apps

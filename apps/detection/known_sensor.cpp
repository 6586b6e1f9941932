// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "known_sensor.h"

#include <pcl/common/point_tests.h>

#include <Eigen/Geometry>

#include <pcl_ops/visibility.h>

namespace pcl_ops::apps {

namespace {

/** \brief Whether a position lies inside the bounding box of the points. */
bool
isAmidPoints (const Eigen::Vector3f& position, const XyzCloud& cloud)
{
  Eigen::AlignedBox3f box;
  for (const pcl::PointXYZ& point : cloud)
    if (pcl::isFinite (point))
      box.extend (point.getVector3fMap());
  return box.contains (position);
}

} // namespace

std::optional<Eigen::Vector3d>
knownSensor (const FileCloud& cloud, const ShiftedCloud& shifted)
{
  const Eigen::Vector3f sensor = shifted.cloud->sensor_origin_.head<3>();
  const bool has_several_scans = !cloud.scans.empty();
  if (has_several_scans ||
      (cloud.is_survey && !isAmidPoints (sensor, *shifted.cloud)) ||
      !isSeenFromItsOrigin (*shifted.cloud))
    return std::nullopt;
  return sensor.cast<double>() + shifted.shift;
}

} // namespace pcl_ops::apps

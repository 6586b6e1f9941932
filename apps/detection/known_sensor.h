// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/shifted_cloud.h>

#include <optional>

namespace pcl_ops::apps {

/** \brief Returns the position of the sensor in the file's frame, as the viewpoint for
 * \ref planeKinds. Returns nothing for a cloud of several scans, and for a position
 * that the cloud cannot have been seen from (isSeenFromItsOrigin). A survey has no
 * pose: its sensor is at zero if zero lies inside the bounding box of the points. The
 * test takes some milliseconds. */
std::optional<Eigen::Vector3d>
knownSensor (const FileCloud& cloud, const ShiftedCloud& shifted);

} // namespace pcl_ops::apps

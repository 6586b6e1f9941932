// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/shifted_cloud.h>

#include <optional>

namespace pcl_ops::apps {

/** \brief Returns the position of the sensor in the frame of the file, as the viewpoint
 * for \ref planeKinds. Returns nothing for a cloud of several scans, and for a position
 * that the cloud cannot have been seen from (isSeenFromItsOrigin, which takes some
 * milliseconds). The file of a survey has no pose: its sensor is taken to be at zero if
 * that lies inside the bounding box of the points, else it is unknown.
 * \param[in] shifted \p cloud as it is searched */
std::optional<Eigen::Vector3d>
knownSensor (const FileCloud& cloud, const ShiftedCloud& shifted);

} // namespace pcl_ops::apps

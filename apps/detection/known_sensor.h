// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/shifted_cloud.h>

#include <optional>

namespace pcl_ops::apps {

/** \brief Returns the position of the sensor in the frame of the file, as the viewpoint
 * for \ref planeKinds. Returns nothing for a cloud of several scans, and if the cloud
 * cannot have been seen from the position in its file (isSeenFromItsOrigin, which takes
 * some milliseconds). The file of a survey (FileCloud::is_survey) has no position: zero
 * is returned if it lies inside the bounding box of the points, else nothing.
 * \param[in] shifted \p cloud after \ref shiftedCloudOf */
std::optional<Eigen::Vector3d>
knownSensor (const FileCloud& cloud, const ShiftedCloud& shifted);

} // namespace pcl_ops::apps

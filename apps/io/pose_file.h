// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Reads where a camera was, in the format of the TUM RGB-D benchmark (Sturm et
 * al., IROS 2012), a line "timestamp tx ty tz qx qy qz qw" for each frame, or of KITTI,
 * the first three rows of a matrix: from the camera's frame to a common one. Empty
 * lines and those that begin with # do not count.
 * \throws WorkError if it cannot be read, or naming the first line that is no pose */
std::vector<Eigen::Isometry3d>
loadPoses (const std::string& file);

/** \brief Whether poses look like those of KITTI's camera: each is written as 12
 * numbers, and they move along their z, which is where that camera looks, and not along
 * x, which is ahead of its lidar. */
bool
lookLikeCameraOfKitti (const std::string& file,
                       const std::vector<Eigen::Isometry3d>& poses);

/** \brief Reads where the lidar was in the frame of the camera that KITTI's poses are
 * of.
 * \throws WorkError if it cannot be read or has no line "Tr:" or "Tr_velo_to_cam:" */
Eigen::Isometry3d
loadCalibration (const std::string& file);

/** \brief Writes such a file, with the times 0, 1/10, 2/10 s and so on.
 * \throws WorkError if it cannot be written */
void
savePoses (const std::string& file, const std::vector<Eigen::Isometry3d>& poses);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Reads the poses of a camera, each as the transform from the frame of the
 * camera to a common frame. A line has a pose in the format of the TUM RGB-D benchmark
 * (Sturm et al., IROS 2012), "timestamp tx ty tz qx qy qz qw", where the time is in s,
 * the position in m, and the quaternion without unit; or in that of KITTI, the first
 * three rows of the matrix of the transform, row by row. Empty lines and lines that
 * begin with # are skipped.
 * \throws WorkError if the file cannot be read, or has a line that is no pose: the
 * error names the first such line */
std::vector<Eigen::Isometry3d>
loadPoses (const std::string& file);

/** \brief Whether poses look like those of KITTI's camera: the first pose is written as
 * 12 numbers, and the camera moves mostly along its z axis, the viewing direction (a
 * lidar of KITTI would move along x). Poses without motion look so, too.
 * \param[in] file from which \p poses were loaded */
bool
lookLikeCameraOfKitti (const std::string& file,
                       const std::vector<Eigen::Isometry3d>& poses);

/** \brief Reads the transform from the lidar's frame to that of the camera whose poses
 * KITTI has.
 * \throws WorkError if the file cannot be read or has no line "Tr:" or
 * "Tr_velo_to_cam:" */
Eigen::Isometry3d
loadCalibration (const std::string& file);

/** \brief Writes poses in the TUM format, with the timestamps 0, 0.1, 0.2 s and so on.
 * \throws WorkError if the file cannot be written */
void
savePoses (const std::string& file, const std::vector<Eigen::Isometry3d>& poses);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <string>

namespace pcl_ops::apps {

/** \brief Where a cloud was taken from. */
struct Viewpoint {
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
};

/** \brief Checks that a PCD file's header makes sense and that its data is as long as
 * the header says and, where it is text, all numbers, so that PCL's reader can be given
 * the file.
 * \return its VIEWPOINT, of which PCL's reader makes anything where a number is none
 * \throws WorkError naming the line at fault */
Viewpoint
checkPcdFile (const std::string& file);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "found_planes.h"
#include "view_state.h"
#include <io/cloud_file.h>
#include <io/xyz_cloud.h>

#include <vector>

namespace pcl_ops::apps {

/** \brief The colours a cloud comes with; where it has no field rgb or rgba, the height
 * of each point from blue to yellow.
 * \param[in] coordinates of the same points
 * \param[in] up direction against gravity */
std::vector<pcl::RGB>
inputColors (const FileCloud& cloud,
             const XyzCloud& coordinates,
             const Eigen::Vector3f& up);

/** \brief The colour of each plane as a state asks for it. Orientation classes are
 * shaded by the direction of the plane, which tells neighbours of one class apart. */
std::vector<pcl::RGB>
planeColors (const FoundPlanes& found, const ViewState& state);

/** \brief The colour of each point as a state asks for it; where a plane is selected,
 * all others fade.
 * \param[in] input what \ref inputColors gave */
std::vector<pcl::RGB>
pointColors (const FoundPlanes& found,
             const ViewState& state,
             const std::vector<pcl::RGB>& input);

} // namespace pcl_ops::apps

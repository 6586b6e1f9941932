// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <pcl_ops/plane_edges.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Writes where planes meet in one step (\ref writeFile), in double precision.
 * \param[in] file a .json or .ply in the file's frame, or a .vtk for pcl_viewer
 * \param[in] sensor_pose as for savePolyData: a .vtk is written moved
 * \param[in] ids the number of each plane
 * \throws WorkError if it cannot be written */
void
saveEdges (const std::string& file,
           const Eigen::Isometry3d& sensor_pose,
           const PlaneEdges& found,
           const std::vector<std::uint32_t>& ids);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "poly_data.h"
#include <pcl_ops/plane_extent.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Writes the outlines of planes as a mesh in one step, each in the
 * colour its points have in the labelled cloud. Outlines without area are left out.
 * \param[in] file a .ply in the file's frame, or a .vtk for pcl_viewer
 * \param[in] sensor_pose as for \ref savePolyData
 * \param[in] planes by falling size
 * \param[in] ids of the planes, their labels in the cloud
 * \param[in] extents one for each plane
 * \throws WorkError if it cannot be written */
void
saveMesh (const std::string& file,
          const Eigen::Isometry3d& sensor_pose,
          const std::vector<PlaneSegment>& planes,
          const std::vector<std::uint32_t>& ids,
          const std::vector<PlaneExtent>& extents,
          Precision precision);

} // namespace pcl_ops::apps

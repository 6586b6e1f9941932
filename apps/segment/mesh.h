// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <pcl_ops/plane_extent.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Of a mesh's coordinates: PCL's point types cannot read doubles, and single
 * precision loses places far from zero. */
enum class Precision { Single, Double };

/** \brief Writes the outlines of planes as a mesh in one step (\ref writeFile), each in
 * the colour its points have in the labelled cloud. Outlines without area are left out.
 * \param[in] file a .ply in the file's frame, or a .vtk for pcl_viewer
 * \param[in] sensor_pose where pcl_viewer moves the labelled cloud to; it does not know
 * of meshes' poses, so that a .vtk is written moved
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

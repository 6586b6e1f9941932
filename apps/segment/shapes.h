// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_extent.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Of coordinates: PCL's point types cannot read doubles, and single precision
 * loses places far from zero. */
enum class Precision { Single, Double };

/** \brief Writes the outlines of planes as a mesh in one step, each in the color its
 * points have in the labeled cloud. Outlines without area are left out.
 * \param[in] file a .ply in the file's frame, or a .vtk for pcl_viewer
 * \param[in] sensor_pose where pcl_viewer moves the labeled cloud to; it does not know
 * of meshes' poses, so that a .vtk is written moved
 * \param[in] ids of the planes, their labels in the cloud
 * \throws WorkError if it cannot be written */
void
saveMesh (const std::string& file,
          const Eigen::Isometry3d& sensor_pose,
          const std::vector<PlaneSegment>& planes,
          const std::vector<std::uint32_t>& ids,
          const std::vector<PlaneExtent>& extents,
          Precision precision);

/** \brief Writes where planes meet in one step, in double precision.
 * \param[in] file a .json or .ply in the file's frame, or a .vtk as \ref saveMesh
 * \throws WorkError if it cannot be written */
void
saveEdges (const std::string& file,
           const Eigen::Isometry3d& sensor_pose,
           const PlaneEdges& found,
           const std::vector<std::uint32_t>& ids);

} // namespace pcl_ops::apps

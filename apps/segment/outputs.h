// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <io/cloud_file.h>
#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_extent.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Writes the points on no plane, with all fields of the input, as a .pcd
 * or .ply; points
 * without coordinates are left out.
 * \param[in] shifted of the cloud's points
 * \param[in] labels per point, 0 for no plane
 * \throws WorkError if it cannot be written */
void
saveRest (const std::string& file,
          const FileCloud& cloud,
          const ShiftedCloud& shifted,
          const std::vector<std::uint32_t>& labels);

/** \brief Whether \ref savePlaneClouds gives such a name, of a file without its folder.
 */
bool
isPlaneFile (const std::string& name);

/** \brief Writes the points of each plane, with all fields of the input, as
 * plane_001_horizontal.pcd, plane_002_vertical.pcd and so on, numbered as \p planes
 * are. Files of such names that an earlier run has left are removed, so that the folder
 * has the planes of one cloud. Nothing changes there until all are written.
 * \param[in] folder is created where it is missing
 * \param[in] extension of the files, .pcd or .ply
 * \throws WorkError if the folder cannot be written to */
void
savePlaneClouds (const std::string& folder,
                 const FileCloud& cloud,
                 const std::vector<PlaneSegment>& planes,
                 const std::vector<std::uint32_t>& ids,
                 const std::string& extension);

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

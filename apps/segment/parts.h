// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/cloud_file.h>
#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

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

} // namespace pcl_ops::apps

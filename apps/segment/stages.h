// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/detection_report.h>
#include <picture/picture.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Returns the names of the files of --trace, without folder: 1_density.pcd,
 * 1_density.png and so on, two for each stage. */
std::vector<std::string>
stageFiles ();

/** \brief Creates the folder and writes a cloud and a picture for each stage into it,
 * in one step: after an error it is as before. The clouds have the fields x, y, z and
 * rgb, and value, label (0: no label) or both. In the stages regions, joined and planes
 * regions are renumbered: the label of a plane of the result goes to the joined region
 * that has most of its points and no other plane's label yet; all other regions get
 * larger labels.
 * \param[in] cloud the points of \p stages, in the frame of the file
 * \param[in] picture draws these points
 * \return a description of the contents for messages
 * \throws WorkError that names the folder, Interrupted */
std::string
saveStages (const std::string& folder,
            const FileCloud& cloud,
            const std::vector<StageResult>& stages,
            const CloudPicture& picture);

} // namespace pcl_ops::apps

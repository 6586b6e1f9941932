// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/detection_report.h>
#include <picture/picture.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief The files of --trace, without their folder: 1_density.pcd, 1_density.png and
 * so on, two for each stage. */
std::vector<std::string>
stageFiles ();

/** \brief Writes a cloud and a picture for each stage into a folder, which is made, in
 * one step. Clouds have x, y, z, rgb, and the fields value or label (0: none) that the
 * stage has; a region has the label of the plane that it becomes.
 * \return what the folder holds
 * \throws WorkError that names the folder, Interrupted */
std::string
saveStages (const std::string& folder,
            const FileCloud& cloud,
            const std::vector<StageResult>& stages,
            const CloudPicture& picture);

} // namespace pcl_ops::apps

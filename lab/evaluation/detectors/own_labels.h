// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

namespace pcl_ops::evaluation {

/** Labels that a detector of somebody's own gave the points of each cloud, from files
 * DATA_SET/CLOUD.npy, .txt (a label a line) or .pcd (field label) below a folder, or
 * else CLOUD.npy and so on; an extension of the cloud's own name may be left out. They
 * are as many as the cloud's finite points or, of an image, its pixels. 0 is no plane;
 * where a label of the file is negative, negative ones are no plane and 0 is a plane.
 * Times are NaN. The run throws apps::WorkError if there is no file, or a wrong one.
 * \param[in] name_and_folder "NAME=FOLDER"
 * \throw apps::UsageError if the name cannot be that of a row or is taken,
 * apps::WorkError if the folder is none */
Configuration
ownLabels (const std::string& name_and_folder);

} // namespace pcl_ops::evaluation

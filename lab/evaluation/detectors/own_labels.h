// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

namespace pcl_ops::evaluation {

/** Makes a configuration that reads the labels of a user's own detector. For each cloud
 * it reads the first of these files that a folder has: DATA_SET/CLOUD.npy, .txt (one
 * label per line) or .pcd (field label), then CLOUD.npy, .txt or .pcd. CLOUD is the
 * name of the cloud, with or without its extension. A file has one label per finite
 * point or, for an organized cloud, per pixel. Label 0 is no plane; if a file has
 * negative labels, these are no plane and 0 is a plane. Durations are NaN. The run
 * throws apps::WorkError if the file is missing or not valid.
 * \param[in] name_and_folder "NAME=FOLDER"
 * \throw apps::UsageError if the name is taken or not valid in tables and names of
 * files, apps::WorkError if the folder is no folder */
Configuration
ownLabels (const std::string& name_and_folder);

} // namespace pcl_ops::evaluation

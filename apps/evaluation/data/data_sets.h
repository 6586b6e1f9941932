// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_source.h"

namespace pcl_ops::evaluation {

/** \brief How the data sets of \ref dataSetOf are written, for --help. */
extern const char* const data_set_help;

/** \brief The data set a text stands for:
 * "sunrgbd:FOLDER" (refined depth), "sunrgbd-raw:FOLDER", "rooms:FIRST-LAST" and
 * "rooms-raw:FIRST-LAST" (simulated rooms by seed, exact truth), "simulated:N,N,..."
 * (scans of a whole simulated room with so many points), "furniture:FIRST-LAST" (boards
 * on posts in a corner by seed), "survey:FIRST-LAST" (houses by seed),
 * "shapes:FIRST-LAST" (round shapes by seed), "streets:FIRST-LAST" and the same of
 * "streets-32", "streets-16" and "streets-livox" (lidars in streets by seed),
 * "clouds:FOLDER" or "clouds:FILE" (.pcd, .ply and .las files; the field label, where
 * there is one, is the truth).
 * \param[in] up direction against gravity in the files of "clouds"
 * \throw apps::UsageError for any other text, apps::WorkError if the folder has no
 * cloud */
DataSet
dataSetOf (const std::string& text, const Eigen::Vector3d& up);

} // namespace pcl_ops::evaluation

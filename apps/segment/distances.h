// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/cloud_file.h>
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops::apps {

/** \brief For each point of a cloud its signed distance to its plane, positive where
 * the normal points to [m]; NaN on no plane. \param[in] planes in the file's frame */
std::vector<float>
distancesOf (const FileCloud& cloud, const std::vector<PlaneSegment>& planes);

} // namespace pcl_ops::apps

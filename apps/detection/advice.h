// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Which parameter to change where a detector found no plane, or so few of the
 * points with coordinates are on planes that most likely a parameter does not fit the
 * cloud. The end of a sentence; empty elsewhere.
 * \tparam Parameters those of OPS, FSPF or 3D-KHT */
template <typename Parameters>
std::string
adviceFor (const Parameters& parameters,
           const XyzCloud& cloud,
           const std::vector<PlaneSegment>& planes);

} // namespace pcl_ops::apps

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

namespace pcl_ops::apps {

/** \brief Which parameter to change where so few of the points with coordinates are on
 * planes that most likely one does not fit the cloud: the end of a sentence. */
template <typename Parameters>
std::string
adviceFor (const Parameters& parameters,
           const XyzCloud& cloud,
           const std::vector<PlaneSegment>& planes);

} // namespace pcl_ops::apps

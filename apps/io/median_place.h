// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_ops::apps {

/** \brief The median of each coordinate: near most of the places, wherever a few stray
 * to; NaN for none. */
Eigen::Vector3d
medianPlace (const std::vector<Eigen::Vector3d>& places);

} // namespace pcl_ops::apps

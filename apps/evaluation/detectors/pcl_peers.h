// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

namespace pcl_ops::evaluation {

/** \brief pcl-sac, the loop of PCL's tutorial around SACSegmentation, and
 * pcl-region-growing, normals of all points and RegionGrowing. */
void
addPclPeers (std::vector<Configuration>& configurations);

} // namespace pcl_ops::evaluation

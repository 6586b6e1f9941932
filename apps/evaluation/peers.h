// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PointIndices.h>

#include "detectors.h"

namespace pcl_ops::evaluation {

/** \brief Labels 1 .. P of the points of disjoint planes. */
Labels
labelsOf (const std::vector<pcl::PointIndices>& planes, std::size_t points);

/** \brief pcl-sac, the loop of PCL's tutorial around SACSegmentation, and
 * pcl-region-growing, normals of all points and RegionGrowing. */
void
addPclPeers (std::vector<Configuration>& configurations);

/** \brief cgal-ransac, Efficient RANSAC (Schnabel et al. 2007), and
 * cgal-region-growing, both with the normals they need; nothing where this was built
 * without CGAL. */
void
addCgalPeers (std::vector<Configuration>& configurations);

} // namespace pcl_ops::evaluation

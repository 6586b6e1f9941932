// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

namespace pcl_ops::evaluation {

/** \brief cgal-ransac, Efficient RANSAC (Schnabel et al. 2007), and
 * cgal-region-growing, both with the normals they need. */
void
addCgalPeers (std::vector<Configuration>& configurations);

} // namespace pcl_ops::evaluation

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief A plane is thick where the rms distance of its points exceeds this multiple
 * of the noise of its surroundings, \ref surroundingNoise. The ground of a scan of
 * KITTI, which is one plane, reaches 7, planes that people labeled 5.8 (a fused
 * office), hills taken for one plane 15 to 40 (src/doc/decisions.md). */
constexpr double max_thickness_of_plane = 8.0;

/** \brief Divides planes that are thick into connected pieces that are not, and joins
 * pieces while what they make is thin. Leaves of what is thick until it is small go on
 * no plane.
 * \param[in] points_around surroundings of a leaf have so many points
 * \return the planes that changed, of as many as there are then; they have to be fitted
 * again */
std::vector<char>
splitThickPlanes (const LeafCloud& cloud,
                  double points_around,
                  unsigned threads,
                  LeafPlanes& planes);

} // namespace pcl_ops::internal

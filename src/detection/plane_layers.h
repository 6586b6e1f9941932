// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief Splits each plane that consists of two parallel layers, as the two sides of a
 * thin wall, which are so near each other that they are found as one plane. If two
 * groups (\ref bestTwoGroups) explain most of the variance of the signed distances of
 * the points to the plane, the points of the group on the side of the normal become a
 * new plane. A plane of fewer than 50 points is never split.
 * \param[in] points,planes in one frame
 * \param[in] min_apart for each plane the least distance between two layers [m]
 * \param[in,out] labels of the points; the labels of new planes begin at
 * \p is_kept.size()
 * \param[in,out] is_kept for each plane 1, or 0 to skip it; each new plane adds a 1 */
void
splitLayers (const Coordinates& points,
             const std::vector<Plane>& planes,
             const std::vector<double>& min_apart,
             Labels& labels,
             std::vector<char>& is_kept);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief Makes two planes of each that has two layers: the sides of a thin wall are
 * neighbors, so that they come out as one plane. Where two groups explain most of the
 * variance of the signed distances of its points (\ref bestTwoGroups), the points of
 * the upper one get a plane of their own.
 * \param[in] min_apart of each plane, the least distance of its two layers [m]
 * \param[in,out] labels of the points; new planes are numbered from \p is_kept.size()
 * \param[in,out] is_kept for each plane 1, or 0 if it is left alone; new planes are added
 * \return whether any plane was split */
bool
splitLayers (const Coordinates& points,
             const std::vector<Plane>& planes,
             const std::vector<double>& min_apart,
             Labels& labels,
             std::vector<char>& is_kept);

} // namespace pcl_ops::internal

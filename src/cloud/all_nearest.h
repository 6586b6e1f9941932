// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/point_tree.h"

#include <cstddef>

namespace pcl_ops::internal {

/** \brief Finds the nearest neighbors of every point of a k-d tree, without the point
 * itself. Among points at equal distance those with the lowest indices come first.
 *
 * All points of a leaf share the same candidates, which are gathered once. This takes a
 * third of the time of PointTree::find for every point.
 * \param[in] neighbors number of neighbors of a point; below the number of points and
 * below NearestPoints::max_size
 * \param[in] threads largest number of threads; 0: one for each processor
 * \return indices of the points: elements i * neighbors to (i + 1) * neighbors - 1 are
 * the neighbors of point i, the nearest first */
Indices
findAllNearest (const PointTree& tree, std::size_t neighbors, unsigned threads);

} // namespace pcl_ops::internal

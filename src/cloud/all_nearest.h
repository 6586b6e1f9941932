// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/point_tree.h"

#include <cstddef>

namespace pcl_ops::internal {

/** \brief The nearest others of every point, so many of each, nearest first; of equally
 * near ones those with the lowest numbers. By number of the point.
 *
 * The points of a leaf look among the same candidates, which are gathered once: that
 * takes a third of the time of a walk through the tree for each point.
 * \param[in] tree of more points than \p number */
Indices
findAllNearest (const PointTree& tree, std::size_t number, unsigned threads);

} // namespace pcl_ops::internal

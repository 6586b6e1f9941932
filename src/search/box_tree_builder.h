// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search/box_tree.h"
#include <pcl_ops/cloud_view.h>

namespace pcl_ops::internal {

/** \brief Sorts points into the voxels of a uniform grid and builds a tree of boxes
 * over the voxels.
 *
 * The sort takes a pass over the points, the tree is built on the voxels alone:
 * together a fraction of the time of a kd-tree that sorts points at every level. Voxels
 * with many points are split further, so that clouds of any density are searched in
 * logarithmic time. \param[in] points finite points in their local frame \param[in]
 * cloud where they come from: queries and distances are in its frame, so that no
 * rounding to another changes distances; not needed afterwards */
BoxTree
buildBoxTree (const Points& points, const CloudView& cloud);

} // namespace pcl_ops::internal

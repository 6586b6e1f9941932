// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_division.h"
#include "voxels/voxel_neighbors.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief For each leaf itself and those that touch it, be it in a corner. */
struct LeafNeighbors {
  /** \brief Those of a leaf after those of the one before; itself first. */
  Indices neighbors;
  /** \brief Where those of each leaf begin, and where those of the last one end. */
  Indices begin = {0};

  IndexRange
  operator[] (std::size_t leaf) const
  {
    return {neighbors.data() + begin[leaf], neighbors.data() + begin[leaf + 1]};
  }
};

/** \brief Finds leaves of any sizes that touch, by walking down the octree in pairs.
 * \param[in] leaves by ascending code, none within another */
LeafNeighbors
connectLeaves (const std::vector<Leaf>& leaves, unsigned threads);

} // namespace pcl_ops::internal

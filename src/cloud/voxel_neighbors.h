// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/range/iterator_range_core.hpp>

#include "cloud/morton_code.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief A range of indices of voxels or points in contiguous memory. */
using IndexRange = boost::iterator_range<const std::uint32_t*>;

/** \brief For each voxel its neighbors: the occupied voxels of the 3 x 3 x 3 block
 * around it, itself included. Most voxels of a block are empty if the points are on
 * surfaces. */
struct VoxelNeighbors {
  /** \brief Indices of the neighbors, voxel by voxel; those of a voxel in the order of
   * their bits in \ref occupied. */
  std::vector<std::uint32_t> neighbors;
  /** \brief For each voxel the index in \ref neighbors where its neighbors begin; then
   * the size of \ref neighbors. */
  std::vector<std::uint32_t> begin = {0};
  /** \brief For each voxel a bit set: bit x + 4 y + 16 z is set if there is a neighbor
   * at (x, y, z) in the block, each coordinate 0 to 2; (1, 1, 1) is the voxel itself.
   */
  std::vector<std::uint64_t> occupied;

  /** \brief Indices of the neighbors of a voxel. */
  IndexRange
  operator[] (std::size_t voxel) const
  {
    return {neighbors.data() + begin[voxel], neighbors.data() + begin[voxel + 1]};
  }
};

/** \brief The next octree level: voxels of twice the edge, each with up to 2 x 2 x 2 of
 * the smaller ones. */
struct LargerVoxels {
  std::vector<MortonCode> codes; // ascending
  /** \brief For each smaller voxel the index of the larger voxel that contains it. */
  std::vector<std::uint32_t> holding;
  VoxelNeighbors neighbors; // of the larger voxels
};

/** \brief Returns the larger voxels that contain the given ones, without neighbors.
 * \param[in] codes of the smaller voxels, ascending, each once */
LargerVoxels
largerVoxels (const std::vector<MortonCode>& codes);

/** \brief The neighbors of voxels and the octree levels above the voxels. */
struct ConnectedVoxels {
  VoxelNeighbors neighbors;
  /** \brief Levels from twice the edge up to the root; empty for one voxel or none. */
  std::vector<LargerVoxels> larger;
};

/** \brief Finds the neighbors of all voxels, level by level from the octree root down.
 * \param[in] codes of the voxels, ascending, each once
 * \param[in] threads largest number of threads; 0: one for each processor */
ConnectedVoxels
connected (const std::vector<MortonCode>& codes, unsigned threads);

} // namespace pcl_ops::internal

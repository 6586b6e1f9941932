// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/range/iterator_range_core.hpp>

#include "cloud/morton_code.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief Numbers of voxels or points, one after the other. */
using IndexRange = boost::iterator_range<const std::uint32_t*>;

/** \brief For each voxel the occupied ones among its 26 neighbors and, in the middle,
 * itself: most are empty where points are on surfaces. */
struct VoxelNeighbors {
  /** \brief Those of a voxel after those of the one before, by their places. */
  std::vector<std::uint32_t> neighbors;
  /** \brief Where those of each voxel begin, and where those of the last one end. */
  std::vector<std::uint32_t> begin = {0};
  /** \brief Where they are: bit x + 4 y + 16 z for the place x, y, z, each 0 to 2; 1,
   * 1, 1 is the middle. */
  std::vector<std::uint64_t> places;

  IndexRange
  operator[] (std::size_t voxel) const
  {
    return {neighbors.data() + begin[voxel], neighbors.data() + begin[voxel + 1]};
  }
};

/** \brief Voxels of twice the edge, which hold 2 x 2 x 2 others each. */
struct LargerVoxels {
  std::vector<MortonCode> codes;
  /** \brief For each smaller voxel the one here that holds it. */
  std::vector<std::uint32_t> holding;
  VoxelNeighbors neighbors;
};

/** \brief The voxels that hold others, without neighbors.
 * \param[in] codes of the others, ascending, each once */
LargerVoxels
largerVoxels (const std::vector<MortonCode>& codes);

/** \brief The neighbors of voxels, and the levels of the octree above them. */
struct ConnectedVoxels {
  VoxelNeighbors neighbors;
  /** \brief From twice the edge up to the root. */
  std::vector<LargerVoxels> larger;
};

/** \brief Finds the neighbors of voxels, from the root of the octree down.
 * \param[in] codes of the voxels, ascending, each once */
ConnectedVoxels
connected (const std::vector<MortonCode>& codes, unsigned threads);

} // namespace pcl_ops::internal

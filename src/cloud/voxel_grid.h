// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include "cloud/voxel_neighbors.h"
#include <pcl_ops/plane.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_ops::internal {

/** \brief The occupied voxels of a uniform grid with the moments of their points. */
struct VoxelGrid {
  /** \brief Edge of a voxel [m]. */
  double voxel_size = 0.0;
  /** \brief Morton codes of the voxels, ascending: neighbors are near in memory. */
  std::vector<MortonCode> codes;
  /** \brief Indices of all points, voxel by voxel; both grids of \ref VoxelLevels share
   * it. */
  std::shared_ptr<const Indices> order;
  /** \brief For each voxel the index in \ref order where its points begin. */
  Indices first_point;
  /** \brief Moments of each voxel's points about the zero of their frame. */
  std::vector<Moments> moments;
  /** \brief Neighbors of each voxel; empty until \ref connect is called. */
  VoxelNeighbors neighbors;
  /** \brief Octree levels above these voxels, from twice the edge up; empty until
   * \ref connect is called. */
  std::vector<LargerVoxels> larger;

  std::size_t
  size () const
  {
    return codes.size();
  }

  /** \brief Indices of the points in a voxel. */
  IndexRange
  pointsOf (std::size_t voxel) const
  {
    const std::uint32_t* const first = order->data() + first_point[voxel];
    return {first, first + static_cast<std::uint32_t> (moments[voxel].count)};
  }
};

/** \brief Sorts points into voxels and sums up the moments of each voxel.
 * \param[in] positions finite points; coordinates beyond 2^18 voxels from zero are
 * clamped to the outermost voxels
 * \param[in] voxel_size edge of a voxel [m]
 * \param[in] threads largest number of threads; 0: one for each processor
 * \return the grid, without neighbors */
VoxelGrid
voxelize (const Coordinates& positions, double voxel_size, unsigned threads);

/** \brief Fills in \ref VoxelGrid::neighbors and \ref VoxelGrid::larger.
 * \param[in] threads largest number of threads; 0: one for each processor */
void
connect (VoxelGrid& grid, unsigned threads);

/** \brief Returns the sum of the moments of some voxels.
 * \param[in] moments of all voxels
 * \param[in] voxels indices of those to add up */
template <typename Voxels>
Moments
momentsOf (const std::vector<Moments>& moments, const Voxels& voxels)
{
  Moments sum;
  for (const std::uint32_t voxel : voxels)
    sum.addAligned (moments[voxel]);
  return sum;
}

/** \brief Returns the moments of each larger voxel.
 * \param[in] moments of the smaller voxels inside them
 * \param[in] larger voxels of twice the edge */
std::vector<Moments>
momentsOf (const std::vector<Moments>& moments, const LargerVoxels& larger);

/** \brief Returns for each point the index of its voxel. */
Indices
voxelsOfPoints (const VoxelGrid& grid);

/** \brief Two grids of the same points. A coarse voxel has twice the edge of a finest
 * voxel, and contains up to 2 x 2 x 2 occupied finest voxels. */
struct VoxelLevels {
  VoxelGrid finest, coarse;
  /** \brief For each finest voxel the index of the coarse voxel that contains it. */
  Indices coarse_of_finest;
};

/** \brief Makes a coarse grid of the finest one. The coarse grid has no neighbors. */
VoxelLevels
coarsen (VoxelGrid finest);

} // namespace pcl_ops::internal

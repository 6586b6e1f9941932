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
  /** \brief Of each voxel, ascending: neighbors in space are near in memory. */
  std::vector<MortonCode> codes;
  /** \brief Numbers of all points, voxel after voxel; grids of the same share them. */
  std::shared_ptr<const Indices> order;
  /** \brief Where each voxel's points begin there. */
  Indices first_point;
  /** \brief Moments of each voxel's points about the zero of their frame. */
  std::vector<Moments> moments;
  /** \brief Empty until \ref connect, as is the next. */
  VoxelNeighbors neighbors;
  /** \brief The larger voxels that hold these, from twice the edge up. */
  std::vector<LargerVoxels> larger;

  std::size_t
  size () const
  {
    return codes.size();
  }

  /** \brief Numbers of a voxel's points. */
  IndexRange
  pointsOf (std::size_t voxel) const
  {
    const std::uint32_t* const first = order->data() + first_point[voxel];
    return {first, first + static_cast<std::uint32_t> (moments[voxel].count)};
  }
};

/** \brief Sorts points into voxels and adds up their moments.
 * \param[in] positions finite points; coordinates beyond 2^18 voxels from zero share
 * the outermost voxels
 * \return voxels without neighbors */
VoxelGrid
voxelize (const Coordinates& positions, double voxel_size, unsigned threads);

/** \brief Finds the neighbors of each voxel. */
void
connect (VoxelGrid& grid, unsigned threads);

/** \brief Moments of the points of some voxels. */
template <typename Voxels>
Moments
momentsOf (const std::vector<Moments>& moments, const Voxels& voxels)
{
  Moments sum;
  for (const std::uint32_t voxel : voxels)
    sum.addAligned (moments[voxel]);
  return sum;
}

/** \brief Moments of larger voxels.
 * \param[in] moments of the voxels that they hold
 * \param[in] larger voxels of twice the edge */
std::vector<Moments>
momentsOf (const std::vector<Moments>& moments, const LargerVoxels& larger);

/** \brief The voxel of each point. */
Indices
voxelsOfPoints (const VoxelGrid& grid);

/** \brief Points in voxels, and in those of twice the edge, each of which holds 2 x 2 x
 * 2 of the others. */
struct VoxelLevels {
  VoxelGrid finest, coarse;
  /** \brief For each of the finest voxels the coarse one that holds it. */
  Indices coarse_of_finest;
};

/** \brief Joins voxels by eight; the coarse ones have no neighbors. */
VoxelLevels
coarsen (VoxelGrid finest);

} // namespace pcl_ops::internal

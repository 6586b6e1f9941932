// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"
#include "voxels/voxel_neighbors.h"
#include <pcl_ops/plane.h>

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief The occupied voxels of a uniform grid with the moments of the points in each.
 */
struct VoxelGrid {
  /** \brief Edge of a voxel [m]. */
  double voxel_size = 0.0;
  /** \brief Of each occupied voxel, ascending: neighbors in space are near in memory.
   */
  std::vector<MortonCode> codes;
  /** \brief Where each voxel's points begin in \ref VoxelizedPoints::order. */
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

  /** \brief Where a voxel's points end there. */
  std::uint32_t
  endOfPoints (std::size_t voxel) const
  {
    return first_point[voxel] + static_cast<std::uint32_t> (moments[voxel].count);
  }
};

/** \brief Voxels with the numbers of their points, voxel after voxel. */
struct VoxelizedPoints {
  VoxelGrid grid;
  Indices order;
};

/** \brief Sorts points into voxels and adds up their moments.
 * \param[in] positions finite points; coordinates beyond 2^18 voxels from zero share
 * the outermost voxels
 * \param[in] voxel_size edge of a voxel, above 0
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \return voxels without neighbors */
VoxelizedPoints
voxelize (const Coordinates& positions, double voxel_size, unsigned threads);

/** \brief Finds the neighbors of each voxel. */
void
connect (VoxelGrid& grid, unsigned threads);

/** \brief Moments of larger voxels.
 * \param[in] moments of the voxels that they hold
 * \param[in] larger voxels of twice the edge */
std::vector<Moments>
momentsOf (const std::vector<Moments>& moments, const LargerVoxels& larger);

/** \brief The voxel of each point.
 * \param[in] grid the voxels
 * \param[in] order numbers of all points, voxel after voxel */
Indices
voxelsOfPoints (const VoxelGrid& grid, const Indices& order);

/** \brief A grid of twice the voxel size whose voxels hold 2 x 2 x 2 voxels each. */
struct CoarserGrid {
  VoxelGrid grid;
  /** \brief For each finer voxel the coarser one that holds it. */
  Indices voxel_of_finer;
};

/** \brief Joins voxels by eight.
 * \return voxels without neighbors */
CoarserGrid
coarsen (const VoxelGrid& finer);

/** \brief Points in voxels, and in those of twice the edge. */
struct VoxelLevels {
  VoxelizedPoints finest;
  CoarserGrid coarse;
};

/** \brief Divides points into voxels of a given edge [m] and of half of it; those of
 * the given edge have neighbors. The rest as \ref voxelize. */
VoxelLevels
voxelizeTwice (const Coordinates& positions, double voxel_size, unsigned threads);

} // namespace pcl_ops::internal

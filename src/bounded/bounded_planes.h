// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/voxel_grid.h"
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_merging.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief Planes with the voxels that support them: what bounds each to its surface. */
struct BoundedPlanes {
  std::vector<Plane> planes;
  /** \brief Plane of each voxel, or no_plane. */
  Labels plane_of_voxel;
  /** \brief Noise around each voxel of a plane [m]. */
  std::vector<double> noise;
  /** \brief Moments of what each plane has outside of these voxels, for the first so
   * many planes. */
  std::vector<Moments> beyond;
  /** \brief Of the planes these voxels were given at first, what each has become. */
  Labels became;

  /** \brief Number of planes. */
  std::size_t
  size () const
  {
    return planes.size();
  }
};

/** \brief Hands every voxel to the nearest of its own plane and those of its
 * neighbours, and refits all planes. */
void
reassignVoxels (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes);

/** \brief Moments of each plane's voxels. */
std::vector<Moments>
momentsOfPlanes (const VoxelGrid& grid, const BoundedPlanes& planes);

/** \brief Replaces the numbers of planes by those of what they became.
 * \param[in] became for each plane a number below \p number, or no_plane */
void
relabelPlanes (const Labels& became, std::size_t number, BoundedPlanes& planes);

/** \brief Replaces planes by those they were merged into. */
void
renumberPlanes (const MergedPlanes& merged, BoundedPlanes& planes);

/** \brief Calls visit (plane, neighbour) for each neighbour of a voxel that is on a
 * plane, and for the voxel itself if it is. */
template <typename Visit>
void
forNeighboursOnPlanes (const VoxelGrid& grid,
                       const Labels& plane_of_voxel,
                       std::size_t voxel,
                       Visit&& visit)
{
  for (const std::uint32_t neighbour : grid.neighbours[voxel])
    if (const std::int32_t plane = plane_of_voxel[neighbour]; plane != no_plane)
      visit (static_cast<std::size_t> (plane), std::size_t (neighbour));
}

/** \brief Fits each plane to its voxels. */
void
refitPlanes (const VoxelGrid& grid, BoundedPlanes& planes);

/** \brief Moments of some voxels' points. */
Moments
momentsOf (const VoxelGrid& grid, const Indices& voxels);

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/voxel_grid.h"
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_merging.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief Planes with the voxels that support them: what bounds each to its surface. */
struct BoundedPlanes {
  std::vector<Plane> planes;
  /** \brief Of each plane, the rms distance of its points [m]. */
  std::vector<double> noise;
  /** \brief Plane of each voxel, or no_plane. */
  Labels plane_of_voxel;
  /** \brief Moments of what each plane has outside of these voxels, for the first so
   * many planes. */
  std::vector<Moments> moments_elsewhere;

  std::size_t
  size () const
  {
    return planes.size();
  }
};

/** \brief Moments of each plane's points, those elsewhere included. */
std::vector<Moments>
momentsOfPlanes (const VoxelGrid& grid, const BoundedPlanes& planes);

/** \brief Fits each plane to its voxels. */
void
refitPlanes (const VoxelGrid& grid, BoundedPlanes& planes);

/** \brief Replaces planes by those they were merged into; the noise of a merged plane
 * has to be measured anew. */
void
renumberPlanes (const MergedPlanes& merged, BoundedPlanes& planes);

/** \brief A voxel of fewer points does not tell the noise of its points. */
inline constexpr double min_points_of_noise = 16.0;

/** \brief No noise is measured more finely than this [m]. */
inline double
smallestNoise (const VoxelGrid& grid)
{
  constexpr double share_of_a_voxel = 0.03;
  return share_of_a_voxel * grid.voxel_size;
}

/** \brief Measures the noise of planes: the median of the rms distances of the points
 * of their voxels to the plane. At least \ref smallestNoise; a plane without voxels
 * here keeps its noise. */
void
measureNoise (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes);

} // namespace pcl_ops::internal

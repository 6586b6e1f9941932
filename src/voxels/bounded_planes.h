// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/voxel_grid.h"
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_merging.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief Planes with their supporting voxels, which tell where a plane ends. */
struct BoundedPlanes {
  std::vector<Plane> planes;
  /** \brief Noise of each plane [m], by \ref measureNoise. */
  std::vector<double> noise;
  /** \brief For each voxel the index of its plane in \ref planes, or no_plane. */
  Labels plane_of_voxel;
  /** \brief Moments of the points that each plane has outside these voxels. The list
   * may be shorter than \ref planes: planes after its end have no points elsewhere. */
  std::vector<Moments> moments_elsewhere;

  std::size_t
  size () const
  {
    return planes.size();
  }
};

/** \brief Moments of the points of each plane, in these voxels and elsewhere. */
std::vector<Moments>
momentsOfPlanes (const VoxelGrid& grid, const BoundedPlanes& planes);

/** \brief Fits each plane to its points in these voxels and elsewhere. A plane whose
 * points span no plane stays as it is. */
void
refitPlanes (const VoxelGrid& grid, BoundedPlanes& planes);

/** \brief Replaces planes by the planes they were merged into, and sets the noise of
 * all planes to 0: it has to be measured again.
 * \param[in] merged the result of merging \p planes, or a longer list that begins with
 * \p planes; afterwards \p planes has all merged planes of the list */
void
renumberPlanes (const MergedPlanes& merged, BoundedPlanes& planes);

/** \brief Fewest points of a voxel that measure noise by their rms distance to a plane
 * fitted to these points alone. Chosen by hand; src/doc/constants.csv has F with 4. */
inline constexpr double min_points_of_noise = 16.0;

/** \brief Lower bound of the noise measured in a grid [m]. Without it, limits in units
 * of the noise would be 0 for exact points. The share was chosen by hand;
 * src/doc/constants.csv has F with 1e-4. */
inline double
minNoise (const VoxelGrid& grid)
{
  constexpr double share_of_voxel_size = 0.03;
  return share_of_voxel_size * grid.voxel_size;
}

/** \brief Measures the noise of each plane: the median over its voxels of the rms
 * distance of the voxel's points to the plane, at least \ref minNoise. A plane
 * without voxels in this grid keeps its noise; if it has none, it gets
 * \ref minNoise. */
void
measureNoise (const VoxelGrid& grid, unsigned threads, BoundedPlanes& planes);

} // namespace pcl_ops::internal

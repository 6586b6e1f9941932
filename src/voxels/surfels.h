// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/voxel_grid.h"
#include <pcl_ops/plane.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief The plane fitted to the points in the surroundings of a voxel. */
struct Surfel {
  Plane plane;
  /** \brief Rms distance of the surrounding points to the plane [m]: the noise, where
   * the surroundings are flat. */
  double noise = 0.0;
  /** \brief Ratio of the noise to the standard deviation of the points along the
   * plane's narrow direction: 0 for an exact plane, 1 for a ball. */
  double thickness = 1.0;
};

/** \brief The oriented samples of a grid: a surfel for each voxel, or nothing.
 *
 * A neighborhood is 3 x 3 x 3 voxels, at the finest of several resolutions at which it
 * is flat and has enough points; if it is flat at none, at that with the least
 * thickness. So where noise grows with distance, neighborhoods grow as well. Next to an
 * edge, where the neighborhood of a voxel is not flat, the voxel gets the flattest
 * neighborhood of an adjacent voxel whose plane fits its points (the idea of Kuwahara's
 * edge-preserving filter). A voxel gets no surfel if no plane around fits its points,
 * or if its surroundings are far noisier than its own points.
 * \param[in] resolutions number of grids: the given one, and further ones, each with
 * twice the voxel size of the one before
 * \param[in] min_points fewest points of a neighborhood
 * \param[in] plane_of_voxel voxels on planes get no surfel; empty: none is on a plane
 */
std::vector<std::optional<Surfel>>
findSurfels (const VoxelGrid& grid,
             int resolutions,
             double min_points,
             unsigned threads,
             const Labels& plane_of_voxel = {});

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/voxel_grid.h"
#include <pcl_ops/plane.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief The plane of a voxel's surroundings. */
struct Surfel {
  Plane plane;
  /** \brief Rms distance of the surrounding points to the plane [m]: the noise, where
   * the surroundings are flat. */
  double noise = 0.0;
  /** \brief The noise over the spread in the plane's narrow direction: 0 for an exact
   * plane, 1 for a ball. */
  double thickness = 1.0;
};

/** \brief The oriented samples of a grid: a surfel for each voxel, or nothing.
 *
 * The neighborhood is the 3 x 3 x 3 voxels around at the finest of several resolutions
 * that is flat and holds enough points: noise that grows with distance gets the larger
 * neighborhoods it needs. Next to an edge, where the voxel's own neighborhood bends,
 * the flattest one of those around its neighbors that the voxel lies in serves instead
 * (the idea of Kuwahara's edge-preserving filter).
 * \param[in] resolutions grids, each of twice the voxel size of the one before
 * \param[in] min_points fewest points of a neighborhood
 * \param[in] plane_of_voxel voxels on planes need no surfel; empty: none has one */
std::vector<std::optional<Surfel>>
findSurfels (const VoxelGrid& grid,
             int resolutions,
             double min_points,
             unsigned threads,
             const Labels& plane_of_voxel = {});

} // namespace pcl_ops::internal

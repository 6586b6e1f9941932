// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/voxel_grid.h"
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

/** \brief The planes of the 3 x 3 x 3 voxels around each of a grid. */
struct SurfelLevel {
  const VoxelGrid* grid = nullptr;
  /** \brief The voxels of the next level that hold those of this one. */
  const Indices* voxels_above = nullptr;
  std::vector<std::optional<Surfel>> normals;
  /** \brief Of the normals, apart because most are looked at for this only; 1 where
   * there is none. */
  std::vector<double> thickness;
  /** \brief For each voxel the one around it, or itself, with the least thickness. */
  std::vector<std::uint32_t> flattest_around;
};

/** \brief Fits the planes of a level.
 * \param[in] grid connected
 * \param[in] voxels_above those of twice the edge that hold them
 * \param[in] least_points fewest points of a neighborhood
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \return a level that is valid as long as the grid and the voxels above are */
SurfelLevel
normalsOf (const VoxelGrid& grid,
           const Indices& voxels_above,
           double least_points,
           unsigned threads);

/** \brief The oriented samples of a grid: a surfel for each voxel, or nothing.
 *
 * The neighborhood is the 3 x 3 x 3 voxels around at the finest of several levels
 * that is flat and holds enough points: noise that grows with distance gets the larger
 * neighborhoods it needs. Next to an edge, where the voxel's own neighborhood bends,
 * the flattest one of those around its neighbors that the voxel lies in serves instead
 * (the idea of Kuwahara's edge-preserving filter).
 * \param[in] levels 1 to 10, that of the grid first, each of twice the voxel size of
 * the one before
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \param[in] plane_of_voxel voxels on planes need no surfel; empty: none has one */
std::vector<std::optional<Surfel>>
findSurfels (const std::vector<SurfelLevel>& levels,
             unsigned threads,
             const Labels& plane_of_voxel = {});

} // namespace pcl_ops::internal

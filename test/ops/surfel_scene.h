// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/surfels.h"

/** \brief The surfels of a connected grid, from levels of that many sizes. */
inline std::vector<std::optional<pcl_ops::internal::Surfel>>
surfelsIn (const pcl_ops::internal::VoxelGrid& grid,
           int resolutions,
           double least_points,
           unsigned threads,
           const pcl_ops::Labels& plane_of_voxel = {})
{
  pcl_ops::internal::VoxelPyramid pyramid;
  pyramid.grids = {grid};
  pyramid.voxels_above.resize (1);
  for (int coarser = 1; coarser < resolutions; ++coarser)
    coarsen (pyramid);
  if (resolutions > 1)
    connectCoarse (pyramid, threads);
  std::vector<pcl_ops::internal::SurfelLevel> levels;
  for (std::size_t l = 0; l < pyramid.grids.size(); ++l)
    levels.push_back (
        normalsOf (pyramid.grids[l], pyramid.voxels_above[l], least_points, threads));
  return findSurfels (levels, threads, plane_of_voxel);
}

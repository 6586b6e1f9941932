// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/surfels.h"

/** \brief The surfels of a connected grid, from levels of that many sizes. */
inline std::vector<std::optional<pcl_ops::internal::Surfel>>
surfelsIn (const pcl_ops::internal::VoxelGrid& grid,
           int resolutions,
           double least_points,
           unsigned threads)
{
  pcl_ops::internal::VoxelPyramid pyramid;
  pyramid.grids = {grid};
  pyramid.voxels_above.resize (1);
  for (int coarser = 1; coarser < resolutions; ++coarser)
    coarsen (pyramid);
  connect (pyramid, threads);
  return findSurfels (pyramid, least_points, threads);
}

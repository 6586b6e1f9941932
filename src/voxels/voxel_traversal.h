// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/parallel.h"
#include "voxels/voxel_grid.h"

namespace pcl_ops::internal {

/** \brief Voxels that one thread looks at in turn. */
constexpr std::size_t voxels_per_chunk = 1024;

/** \brief Calls visit (voxel) for every voxel, some at the same time. */
template <typename Visit>
void
forVoxels (const VoxelGrid& grid, unsigned threads, Visit&& visit)
{
  parallelFor (
      threads, grid.size(), voxels_per_chunk, [&] (std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          visit (i);
      });
}

} // namespace pcl_ops::internal

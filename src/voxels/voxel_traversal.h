// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/parallel.h"
#include "voxels/voxel_grid.h"

namespace pcl_ops::internal {

/** \brief Voxels that one thread looks at in turn. */
constexpr std::size_t voxels_per_piece = 1024;

/** \brief Calls visit (voxel) for every voxel, some at the same time. */
template <typename Visit>
void
forVoxels (const VoxelGrid& grid, unsigned threads, Visit&& visit)
{
  parallelFor (
      threads, grid.size(), voxels_per_piece, [&] (std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          visit (i);
      });
}

/** \brief A voxel and all that are connected to it.
 * \param[in] take (voxel): whether the voxel belongs to it; asked again of a voxel that
 * was taken, it says no */
template <typename Take>
Indices
connectedVoxels (const VoxelGrid& grid, std::uint32_t start, Take&& take)
{
  Indices connected;
  if (!take (start))
    return connected;
  connected.push_back (start);
  for (std::size_t i = 0; i < connected.size(); ++i)
    for (const std::uint32_t neighbour : grid.neighbours[connected[i]])
      if (take (neighbour))
        connected.push_back (neighbour);
  return connected;
}

} // namespace pcl_ops::internal

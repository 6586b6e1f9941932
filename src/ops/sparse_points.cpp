// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/sparse_points.h"

#include <algorithm>
#include <numeric>

namespace pcl_ops::internal {

namespace {

std::vector<char>
sparseVoxels (const VoxelGrid& grid, double least_points)
{
  std::vector<char> is_sparse (grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const VoxelRange& around = grid.neighbours[i];
    is_sparse[i] = std::accumulate (around.begin(),
                                    around.end(),
                                    0.0,
                                    [&grid] (double points, std::uint32_t voxel) {
                                      return points + grid.moments[voxel].count;
                                    }) < least_points;
  }
  return is_sparse;
}

std::size_t
pointsIn (const std::vector<char>& is_sparse, const VoxelGrid& grid)
{
  double points = 0.0;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (is_sparse[i] != 0)
      points += grid.moments[i].count;
  return static_cast<std::size_t> (points);
}

} // namespace

Indices
sparsePoints (const VoxelGrid& grid,
              const Indices& order,
              const Labels& labels,
              double least_points)
{
  constexpr std::size_t least_share = 100;
  constexpr std::size_t most_share = 2;
  const std::vector<char> is_sparse = sparseVoxels (grid, least_points);
  Indices sparse;
  if (pointsIn (is_sparse, grid) * least_share < labels.size())
    return sparse;
  for (std::size_t voxel = 0; voxel < grid.size(); ++voxel)
    if (is_sparse[voxel] != 0)
      for (std::uint32_t i = grid.first_point[voxel]; i < grid.endOfPoints (voxel); ++i)
        if (labels[order[i]] == no_plane)
          sparse.push_back (order[i]);
  std::sort (sparse.begin(), sparse.end());
  const bool is_cloud = sparse.size() * least_share >= labels.size() &&
                        sparse.size() * most_share <= labels.size();
  return is_cloud ? sparse : Indices();
}

} // namespace pcl_ops::internal

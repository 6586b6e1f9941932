// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/fixed_radius_search.h"

#include "voxels/voxel_size.h"

#include <algorithm>
#include <utility>

namespace pcl_ops::internal {

namespace {

// The radius, or more where voxels would hold next to no points: they cost, too.
double
voxelEdge (const Coordinates& points, double radius)
{
  constexpr double points_per_voxel = 16.0;
  const double most_voxels = static_cast<double> (points.size()) / points_per_voxel;
  return std::max (radius, voxelSizeFor (points, std::max (1.0, most_voxels)));
}

} // namespace

FixedRadiusSearch::FixedRadiusSearch (const Coordinates& points,
                                      double radius,
                                      unsigned threads)
: squared_radius_ (static_cast<float> (radius * radius))
{
  VoxelizedPoints voxelized = voxelize (points, voxelEdge (points, radius), threads);
  connect (voxelized.grid, threads);
  neighbours_of_voxel_ = std::move (voxelized.grid.neighbours);
  voxel_begin_ = std::move (voxelized.grid.first_point);
  voxel_begin_.push_back (static_cast<std::uint32_t> (points.size()));
  points_ = selected (points, voxelized.order);
}

std::size_t
FixedRadiusSearch::find (std::uint32_t point, Indices& neighbours) const
{
  const float x = points_.x[point], y = points_.y[point], z = points_.z[point];
  const auto next_voxel =
      std::upper_bound (voxel_begin_.begin(), voxel_begin_.end(), point);
  const auto own_voxel =
      static_cast<std::size_t> (next_voxel - voxel_begin_.begin()) - 1;
  std::size_t number = 0, looked_at = 0;
  for (const std::uint32_t neighbour : neighbours_of_voxel_[own_voxel]) {
    const std::uint32_t* const voxel = &voxel_begin_[neighbour];
    looked_at += voxel[1] - voxel[0];
    neighbours.resize (number + (voxel[1] - voxel[0]));
    for (std::uint32_t i = voxel[0]; i < voxel[1]; ++i) {
      const float dx = points_.x[i] - x, dy = points_.y[i] - y, dz = points_.z[i] - z;
      // Written always, counted if near: no branch to mispredict.
      neighbours[number] = i;
      number += dx * dx + dy * dy + dz * dz <= squared_radius_;
    }
  }
  neighbours.resize (number);
  return looked_at;
}

} // namespace pcl_ops::internal

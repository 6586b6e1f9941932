// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/depth_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_ops::internal {

namespace {

// Bins along the edge of a face, 1.4 degrees each.
constexpr int edge = 64;

// Where a direction meets the cube: its face and coordinates -1 .. 1 on it.
struct OnCube {
  int face;
  double u, v;
};

OnCube
onCube (const Eigen::Vector3d& direction)
{
  Eigen::Index axis = 0;
  const double largest = direction.cwiseAbs().maxCoeff (&axis);
  return {2 * static_cast<int> (axis) + (direction[axis] < 0.0 ? 1 : 0),
          direction[(axis + 1) % 3] / largest,
          direction[(axis + 2) % 3] / largest};
}

int
binOf (double coordinate)
{
  return std::clamp (
      static_cast<int> (std::floor (0.5 * (coordinate + 1.0) * edge)), 0, edge - 1);
}

std::size_t
indexOf (int face, int row, int column)
{
  return (static_cast<std::size_t> (face) * edge + static_cast<std::size_t> (row)) *
             edge +
         static_cast<std::size_t> (column);
}

} // namespace

DepthBuffer::DepthBuffer (const VoxelGrid& grid, const Eigen::Vector3d& viewpoint)
: viewpoint_ (viewpoint)
, ranges_ (6 * edge * edge, {std::numeric_limits<float>::max(), -1.0f})
{
  for (const Moments& voxel : grid.moments)
    draw (voxel.centroid() - viewpoint, 0.5 * grid.voxel_size);
}

void
DepthBuffer::draw (const Eigen::Vector3d& offset, double half_width)
{
  const double depth = offset.norm();
  // So near that a voxel fills its face.
  if (depth <= half_width)
    return;
  const OnCube at = onCube (offset);
  const double width = half_width / offset.cwiseAbs().maxCoeff();
  const auto range = static_cast<float> (depth);
  for (int row = binOf (at.v - width); row <= binOf (at.v + width); ++row)
    for (int column = binOf (at.u - width); column <= binOf (at.u + width); ++column) {
      Range& bin = ranges_[indexOf (at.face, row, column)];
      bin.nearest = std::min (bin.nearest, range);
      bin.farthest = std::max (bin.farthest, range);
    }
}

Sight
DepthBuffer::lookAt (const Eigen::Vector3d& place, double margin) const
{
  const Eigen::Vector3d offset = place - viewpoint_;
  const double depth = offset.norm();
  if (!(depth > 0.0))
    return Sight::Nothing;
  const OnCube at = onCube (offset);
  const Range& bin = ranges_[indexOf (at.face, binOf (at.v), binOf (at.u))];
  if (bin.farthest < 0.0f)
    return Sight::Nothing;
  if (bin.nearest < depth - margin)
    return Sight::Hidden;
  return bin.nearest > depth + margin ? Sight::Through : Sight::There;
}

} // namespace pcl_ops::internal

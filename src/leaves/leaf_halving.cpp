// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_halving.h"

namespace pcl_ops::internal {

namespace {

constexpr double min_points_of_open = 8.0;
constexpr double min_points_to_halve = 4.0;

std::vector<char>
leavesToHalve (const LeafCloud& cloud, const LeafPlanes& planes)
{
  std::vector<char> is_near_open (cloud.size(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (planes.plane_of_leaf[i] == no_plane && planes.is_curved[i] == 0 &&
        cloud.moments[i].count >= min_points_of_open)
      for (const std::uint32_t k : cloud.neighbors[i])
        is_near_open[k] = 1;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.leaves[i].level == 0 || cloud.moments[i].count < min_points_to_halve)
      is_near_open[i] = 0;
  return is_near_open;
}

// Whether the points of a half lie on the plane of the leaf it comes from.
bool
inheritsPlane (const LeafCloud& cloud,
               const LeafPlanes& planes,
               std::size_t leaf,
               const Leaf& half)
{
  constexpr double max_noises = 2.3;
  Moments moments;
  for (std::uint32_t p = half.begin; p < half.end; ++p)
    moments.add (cloud.points->x[p], cloud.points->y[p], cloud.points->z[p]);
  const double limit = max_noises * planes.noise[leaf];
  return meanSquaredDistance (moments, planes.planes[planes.plane_of_leaf[leaf]]) <=
         limit * limit;
}

} // namespace

HalvedLeaves
halveOpenLeaves (const LeafCloud& cloud, const LeafPlanes& planes)
{
  const std::vector<char> is_halved = leavesToHalve (cloud, planes);
  HalvedLeaves next;
  next.planes.planes = planes.planes;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::size_t first = next.leaves.size();
    if (is_halved[i] != 0)
      halveLeaf (*cloud.points, cloud.leaves[i], next.leaves);
    else
      next.leaves.push_back (cloud.leaves[i]);
    for (std::size_t k = first; k < next.leaves.size(); ++k) {
      std::int32_t plane = planes.plane_of_leaf[i];
      if (is_halved[i] != 0 && plane != no_plane &&
          !inheritsPlane (cloud, planes, i, next.leaves[k]))
        plane = no_plane;
      next.planes.plane_of_leaf.push_back (plane);
      next.planes.noise.push_back (plane == no_plane ? 0.0 : planes.noise[i]);
      next.planes.is_curved.push_back (planes.is_curved[i]);
    }
  }
  return next;
}

} // namespace pcl_ops::internal

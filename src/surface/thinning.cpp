// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "thinning.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace pcl_ops {

namespace {

using Voxel = std::pair<std::int64_t, std::int64_t>;
using Voxels = std::map<Voxel, std::vector<std::size_t>>;

bool
isSurrounded (const Voxels& voxels, const Voxel& voxel)
{
  for (const std::int64_t x : {-1, 0, 1})
    for (const std::int64_t y : {-1, 0, 1})
      if (voxels.count ({voxel.first + x, voxel.second + y}) == 0)
        return false;
  return true;
}

} // namespace

WeightedPoints
thinInside (const PlanarPoints& points, double voxel)
{
  Voxels voxels;
  for (std::size_t i = 0; i < points.size(); ++i)
    voxels[{std::llround (points[i].x() / voxel), std::llround (points[i].y() / voxel)}]
        .push_back (i);
  WeightedPoints thinned;
  for (const auto& [place, members] : voxels) {
    const bool is_inside = isSurrounded (voxels, place);
    for (std::size_t m = 0; m < (is_inside ? 1 : members.size()); ++m) {
      thinned.points.push_back (points[members[m]]);
      thinned.weights.push_back (is_inside ? members.size() : 1);
    }
  }
  return thinned;
}

} // namespace pcl_ops

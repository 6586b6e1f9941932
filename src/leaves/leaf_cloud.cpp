// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_cloud.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

// The least noise to assume in a leaf: a few points in it can look flatter than they
// are.
double
minNoise (const LeafCloud& cloud, const CoordinateSteps& steps, std::size_t leaf)
{
  constexpr double rounding = 0.003;     // of the edge
  constexpr double usual = 0.03;         // of the edge, but no more than
  constexpr double times_expected = 2.0; // the expected noise: sparse leaves are wide
  constexpr double share_of_a_step = 0.5;
  const double edge = cloud.edge[leaf];
  const double expected = cloud.expectedNoise (leaf, cloud.moments[leaf].count);
  const double by_size = std::min (usual * edge, times_expected * expected);
  const double by_steps =
      share_of_a_step * steps.at (cloud.moments[leaf].centroid(), edge);
  return std::max ({rounding * edge, by_size, by_steps});
}

} // namespace

LeafCloud
measureLeaves (const CurvePoints& points,
               const ExpectedNoise& expected,
               const CoordinateSteps& steps,
               std::vector<Leaf> leaves,
               unsigned threads)
{
  LeafCloud cloud{&points, &expected, std::move (leaves)};
  cloud.neighbors = connectLeaves (cloud.leaves, threads);
  cloud.moments.resize (cloud.size());
  for (std::vector<double>* values :
       {&cloud.edge, &cloud.density, &cloud.min_noise, &cloud.lowest_expected})
    values->resize (cloud.size());
  forEach (threads, cloud.size(), [&] (std::size_t i) {
    const Leaf& leaf = cloud.leaves[i];
    for (std::uint32_t p = leaf.begin; p < leaf.end; ++p)
      cloud.moments[i].add (points.x[p], points.y[p], points.z[p]);
    cloud.edge[i] = std::ldexp (points.cell, leaf.level);
    cloud.density[i] = densityOf (cloud.moments[i].count, leaf.level);
    cloud.lowest_expected[i] = expected.lowest (cloud.density[i]);
    cloud.min_noise[i] = minNoise (cloud, steps, i);
  });
  return cloud;
}

std::vector<Moments>
momentsOfPlanes (const LeafCloud& cloud, const LeafPlanes& planes)
{
  std::vector<Moments> moments (planes.planes.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (planes.plane_of_leaf[i] != no_plane)
      moments[planes.plane_of_leaf[i]].addAligned (cloud.moments[i]);
  return moments;
}

void
refitPlanes (const LeafCloud& cloud, LeafPlanes& planes)
{
  const std::vector<Moments> moments = momentsOfPlanes (cloud, planes);
  for (std::size_t p = 0; p < moments.size(); ++p)
    if (const std::optional<PlaneFit> fit = fitPlane (moments[p]))
      planes.planes[p] = fit->plane;
}

} // namespace pcl_ops::internal

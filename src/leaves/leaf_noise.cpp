// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_noise.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

/** \brief Weighted squared distances to a plane, to be averaged. */
struct SquaredDistances {
  double points = 0.0;
  double sum = 0.0; // [m^2]
};

// The sum of each measured leaf's and its neighbors' distances, of the same plane.
std::vector<SquaredDistances>
sumsAround (const LeafCloud& cloud,
            const LeafPlanes& planes,
            const Indices& measured,
            const std::vector<SquaredDistances>& of_leaf,
            unsigned threads)
{
  std::vector<SquaredDistances> sums (of_leaf.size());
  forEach (threads, measured.size(), [&] (std::size_t m) {
    const std::uint32_t leaf = measured[m];
    for (const std::uint32_t k : cloud.neighbors[leaf])
      if (planes.plane_of_leaf[k] == planes.plane_of_leaf[leaf]) {
        sums[leaf].points += of_leaf[k].points;
        sums[leaf].sum += of_leaf[k].sum;
      }
  });
  return sums;
}

double
limitedNoise (const LeafCloud& cloud, std::size_t leaf, const SquaredDistances& around)
{
  // Without it a ground takes the bushes beside it.
  constexpr double max_expected = 5.0;
  const double points = std::max (1.0, around.points);
  double noise = std::sqrt (around.sum / points);
  if (noise > max_expected * cloud.lowest_expected[leaf])
    noise = std::min (noise, max_expected * cloud.expectedNoise (leaf, points));
  return std::max (noise, cloud.min_noise[leaf]);
}

} // namespace

void
measureNoise (const LeafCloud& cloud,
              unsigned threads,
              LeafPlanes& planes,
              const std::vector<char>* changed)
{
  constexpr int rings = 2;
  Indices measured;
  std::vector<SquaredDistances> sums (cloud.size());
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    const std::int32_t plane = planes.plane_of_leaf[i];
    if (plane == no_plane) {
      planes.noise[i] = 0.0;
      continue;
    }
    if (changed != nullptr && (*changed)[plane] == 0)
      continue;
    const double points = cloud.moments[i].count;
    sums[i] = {points,
               points * meanSquaredDistance (cloud.moments[i], planes.planes[plane])};
    measured.push_back (i);
  }
  for (int ring = 0; ring < rings; ++ring)
    sums = sumsAround (cloud, planes, measured, sums, threads);
  forEach (threads, measured.size(), [&] (std::size_t m) {
    planes.noise[measured[m]] = limitedNoise (cloud, measured[m], sums[measured[m]]);
  });
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_surfels.h"

#include "base/parallel.h"
#include "geometry/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

// A surrounding as flat as this will do: larger ones are not looked at.
constexpr double flat_enough = 0.13;

// The sum of each leaf's and its neighbors' moments.
std::vector<Moments>
nextRing (const LeafCloud& cloud, const std::vector<Moments>& ring, unsigned threads)
{
  std::vector<Moments> sums (cloud.size());
  forEach (threads, cloud.size(), [&] (std::size_t i) {
    for (const std::uint32_t k : cloud.neighbors[i])
      sums[i].addAligned (ring[k]);
  });
  return sums;
}

LeafSurfel
toSurfel (const Moments& around, const PrincipalAxes& axes, double edge)
{
  // Surroundings narrower than this share of a leaf are a line.
  constexpr double min_width = 0.75;
  LeafSurfel surfel;
  const double width = min_width * edge;
  if (axes.normal.isZero() || 12.0 * axes.values[1] < width * width)
    return surfel;
  constexpr double largest = 0.999;
  surfel.plane = planeThrough (around.centroid(), axes.normal);
  surfel.noise = std::sqrt (std::max (0.0, axes.values[0]));
  surfel.thickness =
      std::min (largest, std::sqrt (std::max (0.0, axes.values[0]) / axes.values[1]));
  return surfel;
}

// The planes of the surroundings that are asked for.
void
measureRing (const LeafCloud& cloud,
             const std::vector<Moments>& ring,
             const std::vector<char>& is_asked,
             double min_points,
             unsigned threads,
             std::vector<LeafSurfel>& surfels)
{
  Indices asked;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    surfels[i] = LeafSurfel();
    if (is_asked[i] != 0 && ring[i].count >= min_points)
      asked.push_back (i);
  }
  constexpr std::size_t at_once = 256;
  parallelFor (
      threads, asked.size(), at_once, [&] (std::size_t begin, std::size_t end) {
        std::vector<Eigen::Matrix3d> covariances;
        for (std::size_t k = begin; k < end; ++k)
          covariances.push_back (ring[asked[k]].covariance());
        std::vector<PrincipalAxes> axes (covariances.size());
        principalAxes (covariances.data(), covariances.size(), axes.data());
        for (std::size_t k = begin; k < end; ++k)
          surfels[asked[k]] =
              toSurfel (ring[asked[k]], axes[k - begin], cloud.edge[asked[k]]);
      });
}

// The flattest of a leaf's surrounding and those next to it that its points lie on.
LeafSurfel
flattestAround (const LeafCloud& cloud,
                const std::vector<LeafSurfel>& of_ring,
                std::size_t leaf,
                const LeafSurfel& before)
{
  // Of the noise: a leaf takes the normal of a neighbor that its points fit.
  constexpr double max_distance = 1.8;
  LeafSurfel best = before;
  const auto consider = [&] (const LeafSurfel& surfel) {
    if (surfel.thickness >= best.thickness)
      return;
    const double limit = max_distance * std::max (surfel.noise, cloud.min_noise[leaf]);
    if (meanSquaredDistance (cloud.moments[leaf], surfel.plane) < limit * limit)
      best = surfel;
  };
  if (of_ring[leaf].thickness < flat_enough)
    consider (of_ring[leaf]);
  if (best.thickness >= flat_enough)
    for (const std::uint32_t k : cloud.neighbors[leaf])
      consider (of_ring[k]);
  return best;
}

// Whether surroundings much noisier than the leaf itself hide a finer surface in it.
bool
hidesSurface (const LeafCloud& cloud, std::size_t leaf, const LeafSurfel& surfel)
{
  constexpr double times_noise = 6.0;
  constexpr double min_points = 16.0;
  const Moments& own = cloud.moments[leaf];
  if (!surfel.exists() || own.count < min_points ||
      surfel.noise <= times_noise * cloud.min_noise[leaf])
    return false;
  const double variance =
      principalAxes (own.covariance()).values[0] * own.count / (own.count - 3.0);
  return surfel.noise * surfel.noise > times_noise * times_noise * variance;
}

// The noise that half of the points on flat surfels are below.
double
medianNoise (const LeafCloud& cloud, const std::vector<LeafSurfel>& surfels)
{
  constexpr double max_thickness = 0.265;
  std::vector<std::pair<double, double>> noises; // with the points
  double points = 0.0;
  for (std::size_t i = 0; i < surfels.size(); ++i)
    if (surfels[i].thickness < max_thickness) {
      noises.emplace_back (surfels[i].noise, cloud.moments[i].count);
      points += cloud.moments[i].count;
    }
  std::sort (noises.begin(), noises.end());
  double below = 0.0;
  for (const auto& [noise, count] : noises) {
    below += count;
    if (below >= 0.5 * points)
      return noise;
  }
  return 0.0;
}

// What is far noisier than most of the cloud supports no plane.
void
rejectOutlyingNoise (const LeafCloud& cloud, std::vector<LeafSurfel>& surfels)
{
  constexpr double max_medians = 25.0;
  const double limit = max_medians * medianNoise (cloud, surfels);
  for (LeafSurfel& surfel : surfels)
    if (limit > 0.0 && surfel.noise > limit)
      surfel = LeafSurfel();
}

} // namespace

std::vector<LeafSurfel>
orientLeaves (const LeafCloud& cloud,
              const LeafPlanes& planes,
              const LeafSurfelParameters& parameters,
              unsigned threads)
{
  std::vector<LeafSurfel> found (cloud.size());
  std::vector<char> is_open (cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    is_open[i] = planes.plane_of_leaf[i] == no_plane && planes.is_curved[i] == 0;
  std::vector<Moments> ring = cloud.moments;
  std::vector<LeafSurfel> of_ring (cloud.size());
  for (int r = 0; r < parameters.rings; ++r) {
    ring = nextRing (cloud, ring, threads);
    const auto looksOn = [&] (std::size_t i) {
      return is_open[i] != 0 && found[i].thickness >= flat_enough;
    };
    std::vector<char> is_asked (cloud.size(), 0);
    forEach (threads, cloud.size(), [&] (std::size_t i) {
      const IndexRange around = cloud.neighbors[i];
      is_asked[i] = std::any_of (around.begin(), around.end(), looksOn);
    });
    measureRing (cloud, ring, is_asked, parameters.min_points, threads, of_ring);
    forEach (threads, cloud.size(), [&] (std::size_t i) {
      if (looksOn (i))
        found[i] = flattestAround (cloud, of_ring, i, found[i]);
    });
  }
  forEach (threads, cloud.size(), [&] (std::size_t i) {
    if (hidesSurface (cloud, i, found[i]))
      found[i] = LeafSurfel();
  });
  rejectOutlyingNoise (cloud, found);
  return found;
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/surrounding_noise.h"

#include "base/parallel.h"
#include "geometry/points.h"
#include "geometry/principal_axes.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// Scatter of a leaf's points, and of those of its plane beside it, about the plane
// through them [m], within limits of what the cloud shows elsewhere; 0 where they are
// few, or on a line like those of one lidar beam, and where the cloud shows nothing.
double
noiseAround (const LeafCloud& cloud,
             const Labels& plane_of_leaf,
             std::uint32_t leaf,
             double points_around)
{
  constexpr double min_points = 8.0;
  constexpr double min_width = 0.2; // over the length
  // A rough slope is noise to itself. Without this limit half of the points of airborne
  // surveys are on planes thicker than 50 cm.
  constexpr double max_expected = 1.25;
  Moments around = cloud.moments[leaf];
  for (const std::uint32_t k : cloud.neighbors[leaf])
    if (k != leaf && plane_of_leaf[k] == plane_of_leaf[leaf] &&
        around.count < points_around)
      around.addAligned (cloud.moments[k]);
  if (around.count < min_points)
    return 0.0;
  const PrincipalAxes axes = principalAxes (around.covariance());
  if (axes.values[1] < min_width * min_width * axes.values[2])
    return 0.0;
  const double variance =
      std::max (0.0, axes.values[0]) * around.count / (around.count - 3.0);
  const double expected = cloud.expectedNoise (leaf, points_that_tell * around.count);
  if (!ExpectedNoise::isKnown (expected))
    return 0.0;
  return std::clamp (std::sqrt (variance), expected, max_expected * expected);
}

} // namespace

std::optional<double>
surroundingNoise (const LeafCloud& cloud,
                  const Labels& plane_of_leaf,
                  const Indices& leaves,
                  double points_around)
{
  constexpr std::size_t wanted = 300;
  constexpr std::size_t enough = 3;
  std::vector<float> noises;
  const std::size_t step = leaves.size() / wanted + 1;
  for (std::size_t i = 0; i < leaves.size(); i += step) {
    const double noise = noiseAround (cloud, plane_of_leaf, leaves[i], points_around);
    if (noise > 0.0)
      noises.push_back (static_cast<float> (noise));
  }
  if (noises.size() < enough)
    return std::nullopt;
  return medianOf (noises);
}

std::vector<std::optional<double>>
expectedNoises (const ExpectedNoise& expected,
                const std::vector<Leaf>& leaves,
                const Labels& plane_of_leaf,
                std::size_t planes,
                double points)
{
  std::vector<std::vector<float>> noises (planes);
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (plane_of_leaf[i] == no_plane)
      continue;
    const double own = leaves[i].end - leaves[i].begin;
    const double noise =
        expected.of (densityOf (own, leaves[i].level), std::max (own, points));
    if (ExpectedNoise::isKnown (noise))
      noises[plane_of_leaf[i]].push_back (static_cast<float> (noise));
  }
  std::vector<std::optional<double>> medians (planes);
  for (std::size_t plane = 0; plane < planes; ++plane)
    if (!noises[plane].empty())
      medians[plane] = medianOf (noises[plane]);
  return medians;
}

std::vector<std::optional<double>>
surroundingNoises (const LeafCloud& cloud,
                   const Labels& plane_of_leaf,
                   std::size_t planes,
                   double points_around,
                   unsigned threads)
{
  std::vector<std::optional<double>> noises =
      expectedNoises (*cloud.expected,
                      cloud.leaves,
                      plane_of_leaf,
                      planes,
                      points_that_tell * points_around);
  std::vector<Indices> leaves (planes);
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if (plane_of_leaf[i] != no_plane)
      leaves[plane_of_leaf[i]].push_back (i);
  parallelFor (threads, planes, 1, [&] (std::size_t plane, std::size_t) {
    if (const std::optional<double> measured =
            surroundingNoise (cloud, plane_of_leaf, leaves[plane], points_around))
      noises[plane] = measured;
  });
  return noises;
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/oriented_points.h"

#include "base/parallel.h"
#include "base/random.h"
#include "cloud/box_tree.h"
#include "geometry/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace pcl_ops::internal {

Indices
drawSample (std::size_t size, double rate, std::uint32_t seed)
{
  const double drawn_share = std::min (1.0, std::max (0.0, rate));
  auto still_to_draw = static_cast<std::size_t> (
      std::llround (drawn_share * static_cast<double> (size)));
  RandomGenerator generator (seed);
  Indices sample;
  sample.reserve (still_to_draw);
  // Each point is drawn with the probability
  // still_to_draw / (number of points from this one to the last).
  for (std::size_t i = 0; still_to_draw > 0; ++i)
    if (drawBelow (generator, static_cast<std::uint32_t> (size - i)) < still_to_draw) {
      sample.push_back (static_cast<std::uint32_t> (i));
      --still_to_draw;
    }
  return sample;
}

namespace {

Eigen::Vector3d
positionIn (const CloudView& cloud, pcl::index_t index)
{
  const float* const position = cloud[index];
  return {position[0], position[1], position[2]};
}

// M_i of one sample, see orientSamples.
// \param[in] given_sigma sigma [m]; without it sigma is the distance to the farthest
// neighbor
Eigen::Matrix3d
weightedScatter (const CloudView& cloud,
                 pcl::index_t sample,
                 const pcl::Indices& neighbors,
                 const std::vector<float>& squared_distances,
                 std::optional<double> given_sigma)
{
  float max_squared_distance = 0.0f;
  for (const float squared_distance : squared_distances)
    max_squared_distance = std::max (max_squared_distance, squared_distance);
  const double sigma = given_sigma.value_or (std::sqrt (max_squared_distance));
  const Eigen::Vector3d position = positionIn (cloud, sample);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const pcl::index_t neighbor : neighbors) {
    const Eigen::Vector3d offset = positionIn (cloud, neighbor) - position;
    const double squared_distance = offset.squaredNorm();
    if (squared_distance == 0.0)
      continue;
    const double weight = std::exp (-squared_distance / (2.0 * sigma * sigma));
    scatter.noalias() += (weight / squared_distance) * offset * offset.transpose();
  }
  return scatter;
}

} // namespace

NeighborSearch
searchOver (const DetectorInput& input, const Points& points, unsigned threads)
{
  if (input.search_over)
    return input.search_over (points.index);
  const auto tree = std::make_shared<const BoxTree> (points, input.cloud);
  const auto nearest = [tree,
                        cloud = input.cloud] (pcl::index_t point,
                                              int k,
                                              pcl::Indices& neighbors,
                                              std::vector<float>& squared_distances) {
    const Eigen::Vector3f position = positionIn (cloud, point).cast<float>();
    NeighborQuery query{position, static_cast<std::size_t> (k)};
    query.sorted = false;
    tree->find (query, neighbors, squared_distances);
  };
  const auto no_search_within_radius = nullptr;
  return {nearest, no_search_within_radius, threads};
}

Eigen::Vector3d
normalOfScatter (const Eigen::Matrix3d& scatter)
{
  const PrincipalAxes axes = principalAxes (scatter);
  // Points in a strip narrower than a thousandth of its length count as a line, because
  // rounding would decide the normal.
  constexpr double min_relative_variance = 1e-6;
  if (!(axes.values[1] > min_relative_variance * axes.values[2]))
    return Eigen::Vector3d::Zero();
  return axes.normal;
}

OrientedSamples
orientSamples (const CloudView& cloud,
               const Points& points,
               const Indices& sample,
               const NeighborSearch& search,
               int k,
               std::optional<double> sigma)
{
  // One more than k: the nearest neighbor of a point is the point itself, which does
  // not count as a neighbor (q_ij).
  const auto wanted_neighbors =
      static_cast<int> (std::min (static_cast<std::size_t> (k) + 1, points.size()));
  constexpr std::size_t samples_per_piece = 256; // of the parallel loop
  std::vector<Eigen::Vector3d> normals (sample.size());
  parallelFor (
      search.threads,
      sample.size(),
      samples_per_piece,
      [&] (std::size_t begin, std::size_t end) {
        pcl::Indices neighbors;
        std::vector<float> squared_distances;
        for (std::size_t i = begin; i < end; ++i) {
          const pcl::index_t point = points.indexOf (sample[i]);
          search.nearest (point, wanted_neighbors, neighbors, squared_distances);
          normals[i] = normalOfScatter (
              weightedScatter (cloud, point, neighbors, squared_distances, sigma));
        }
      });
  OrientedSamples samples;
  for (std::size_t i = 0; i < sample.size(); ++i)
    if (!normals[i].isZero())
      samples.add (points[sample[i]], normals[i]);
  return samples;
}

std::array<Indices, 3>
groupByOrientation (const OrientedSamples& samples,
                    const Eigen::Vector3d& up,
                    double tolerance)
{
  std::array<Indices, 3> groups;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Orientation group = orientationOf (samples.normals[i], up, tolerance);
    groups[static_cast<std::size_t> (group)].push_back (static_cast<std::uint32_t> (i));
  }
  return groups;
}

} // namespace pcl_ops::internal

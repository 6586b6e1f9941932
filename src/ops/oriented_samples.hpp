// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/oriented_samples.h>
#include <pcl_ops/parallel.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

/** \brief M_i of one sample, in the frame of its position. */
template <typename PointT>
Eigen::Matrix3d
weightedScatter (const pcl::PointCloud<PointT>& cloud,
                 const PointT& sample,
                 const pcl::Indices& neighbours,
                 const std::vector<float>& squared_distances,
                 double sigma)
{
  if (sigma <= 0.0) {
    const auto farthest =
        std::max_element (squared_distances.begin(), squared_distances.end());
    sigma = farthest == squared_distances.end() ? 0.0 : std::sqrt (*farthest);
  }
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const pcl::index_t neighbour : neighbours) {
    const Eigen::Vector3d q =
        (cloud[neighbour].getVector3fMap().template cast<double>() -
         sample.getVector3fMap().template cast<double>());
    const double squared_distance = q.squaredNorm();
    if (squared_distance == 0.0)
      continue;
    const double weight = std::exp (-squared_distance / (2.0 * sigma * sigma));
    scatter.noalias() += (weight / squared_distance) * q * q.transpose();
  }
  return scatter;
}

template <typename PointT>
OrientedSamples
orientSamples (const pcl::PointCloud<PointT>& cloud,
               const Points& points,
               const Positions& sample,
               const pcl::search::Search<PointT>& search,
               const NormalParameters& parameters,
               unsigned threads)
{
  // The nearest neighbour of a point of the cloud is the point itself: q_ij != p_i.
  const auto k = static_cast<int> (
      std::min (static_cast<std::size_t> (parameters.k) + 1, points.size()));
  constexpr std::size_t samples_per_piece = 256;
  std::vector<Eigen::Vector3d> normals (sample.size());
  parallelFor (threads,
               sample.size(),
               samples_per_piece,
               [&] (std::size_t begin, std::size_t end) {
                 pcl::Indices neighbours;
                 std::vector<float> squared_distances;
                 for (std::size_t i = begin; i < end; ++i) {
                   const PointT& point = cloud[points.indexOf (sample[i])];
                   search.nearestKSearch (point, k, neighbours, squared_distances);
                   normals[i] = normalOfScatter (weightedScatter (
                       cloud, point, neighbours, squared_distances, parameters.sigma));
                 }
               });
  OrientedSamples samples;
  for (std::size_t i = 0; i < sample.size(); ++i)
    if (!normals[i].isZero())
      samples.add (points[sample[i]], normals[i]);
  return samples;
}

} // namespace pcl_ops

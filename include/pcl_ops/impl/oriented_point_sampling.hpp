// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/stage_timer.h>

namespace pcl_ops {

template <typename PointT>
Detection
OrientedPointSampling<PointT>::detect()
{
  Detection found;
  found.points = finitePoints (*input_, *indices_, parameters_.threads);
  if (parameters_.sampling == Sampling::Cells)
    return detectOnCells (
        std::move (found.points), this->viewpoint(), parameters_, durations_);
  const Points& points = found.points;
  found.labels.assign (points.size(), no_plane);
  // P_s: alpha_s N of the points
  const Positions sample =
      drawSample (points.size(), parameters_.sampling_rate, parameters_.seed);
  if (sample.empty())
    return found;
  const auto search =
      timed (durations_.search, [&] { return this->searchOver (points); });
  // n_i: eigenvector of M_i's smallest eigenvalue
  const OrientedSamples samples = timed (durations_.normals, [&] {
    return orientSamples (
        *input_, points, sample, *search, parameters_.normals, this->searchThreads());
  });
  // Pi: one-point RANSAC and peeling, with theta_h, theta_N and p
  const std::vector<Plane> planes = timed (durations_.extraction, [&] {
    return extractPlanes (samples, points, parameters_);
  });
  // every point of P, not of P_s alone, to a plane within theta_h
  found.labels = timed (durations_.assignment, [&] {
    return assignPoints (points,
                         planes,
                         parameters_.distance_threshold,
                         parameters_.assignment_rule,
                         parameters_.threads);
  });
  // section III-C: the coplanarity test on each pair
  found.planes = timed (durations_.merging, [&] {
    return mergeLabelled (points,
                          found.labels,
                          planes.size(),
                          this->mergingParameters(),
                          parameters_.threads);
  });
  return found;
}

} // namespace pcl_ops

#define PCL_INSTANTIATE_OrientedPointSampling(T)                                       \
  template class PCL_EXPORTS pcl_ops::OrientedPointSampling<T>;

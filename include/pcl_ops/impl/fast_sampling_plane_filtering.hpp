// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/stage_timer.h>

#include <limits>

namespace pcl_ops {

/** \brief Spheres by any search of PCL.
 * \param[in] cloud the input cloud
 * \param[in] points the finite points of it; used as long as the finder is
 * \param[in] search its input is the finite points; used as long as the finder is
 * \param[in] radius r2 [m] */
template <typename PointT>
SphereFinder
sphereFinder (const pcl::PointCloud<PointT>& cloud,
              const Points& points,
              const pcl::search::Search<PointT>& search,
              double radius)
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  Positions position_of (cloud.size(), none);
  for (std::size_t i = 0; i < points.size(); ++i)
    position_of[static_cast<std::size_t> (points.indexOf (i))] =
        static_cast<std::uint32_t> (i);
  return [&cloud, &points, &search, radius, position_of] (std::uint32_t centre,
                                                          Positions& sphere) {
    pcl::Indices neighbours;
    std::vector<float> squared_distances;
    search.radiusSearch (
        cloud[points.indexOf (centre)], radius, neighbours, squared_distances);
    sphere.clear();
    for (const pcl::index_t neighbour : neighbours)
      if (position_of[static_cast<std::size_t> (neighbour)] != none)
        sphere.push_back (position_of[static_cast<std::size_t> (neighbour)]);
  };
}

template <typename PointT>
LocalPlanes
FastSamplingPlaneFiltering<PointT>::samplePlanes (const Points& points)
{
  if (!search_ || points.size() == 0)
    return sampleLocalPlanes (points, parameters_, durations_);
  const auto search =
      timed (durations_.search, [&] { return this->searchOver (points); });
  return timed (durations_.extraction, [&] {
    return sampleLocalPlanes (
        points,
        sphereFinder (*input_, points, *search, parameters_.local.outer_radius),
        parameters_.local,
        parameters_.distance_threshold,
        parameters_.seed);
  });
}

template <typename PointT>
Detection
FastSamplingPlaneFiltering<PointT>::detect()
{
  Detection found;
  found.points = finitePoints (*input_, *indices_, parameters_.threads);
  const Points& points = found.points;
  // Pi: planes of spheres that pass the local test
  const LocalPlanes local = samplePlanes (points);
  // section III-C: the coplanarity test on each pair
  const MergedPlanes merged = timed (durations_.merging, [&] {
    return mergePlanes (local.moments, this->mergingParameters());
  });
  // every point of P, not of the spheres alone, to the largest plane within theta_h
  found.labels = timed (durations_.assignment, [&] {
    return assignPoints (points,
                         planesOf (merged),
                         parameters_.distance_threshold,
                         AssignmentRule::First,
                         parameters_.threads);
  });
  found.planes = timed (durations_.merging, [&] {
    return refitAssigned (
        points, found.labels, merged, this->mergingParameters(), parameters_.threads);
  });
  return found;
}

} // namespace pcl_ops

#define PCL_INSTANTIATE_FastSamplingPlaneFiltering(T)                                  \
  template class PCL_EXPORTS pcl_ops::FastSamplingPlaneFiltering<T>;

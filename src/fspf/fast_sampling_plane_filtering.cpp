// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/fixed_radius_search.h>
#include <pcl_ops/stage_timer.h>

#include <cmath>

namespace pcl_ops {

FastSamplingPlaneFilteringParameters
FastSamplingPlaneFilteringParameters::paper()
{
  FastSamplingPlaneFilteringParameters parameters;
  parameters.local.inner_radius = 0.07;
  parameters.local.outer_radius = 0.14;
  parameters.local.local_samples = 80;
  parameters.local.min_inlier_fraction = 0.8;
  parameters.distance_threshold = 0.05;
  return parameters;
}

namespace {

bool
isAboveZero (double value)
{
  return value > 0.0 && std::isnormal (value);
}

} // namespace

std::string
problemOf (const FastSamplingPlaneFilteringParameters& parameters)
{
  constexpr unsigned points_of_a_plane = 3;
  const LocalSamplingParameters& local = parameters.local;
  if (!isAboveZero (local.inner_radius))
    return "the inner radius must be a length above 0";
  if (!(isAboveZero (local.outer_radius) && local.outer_radius >= local.inner_radius))
    return "the outer radius must be a length, and not below the inner radius";
  if (local.local_samples < points_of_a_plane)
    return "the number of local samples must be 3 or more";
  if (!(local.min_inlier_fraction >= 0.0 && local.min_inlier_fraction < 1.0))
    return "the smallest inlier fraction must be 0 or more and below 1";
  if (!isAboveZero (local.max_inliers_per_point))
    return "the number of inliers per point to end at must be above 0";
  if (!isAboveZero (local.max_hypotheses_per_point))
    return "the number of hypotheses per point to end at must be above 0";
  if (!isAboveZero (local.max_visits_per_point))
    return "the number of visits per point to end at must be above 0";
  return problemOf (static_cast<const PlaneDetectorParameters&> (parameters));
}

LocalPlanes
sampleLocalPlanes (const Points& points,
                   const FastSamplingPlaneFilteringParameters& parameters,
                   StageDurations& durations)
{
  const FixedRadiusSearch search = timed (durations.search, [&] {
    return FixedRadiusSearch (
        points, parameters.local.outer_radius, parameters.threads);
  });
  return timed (durations.extraction, [&] {
    return sampleLocalPlanes (
        search.points(),
        [&] (std::uint32_t centre, Positions& sphere) { search.find (centre, sphere); },
        parameters.local,
        parameters.distance_threshold,
        parameters.seed);
  });
}

std::vector<Plane>
planesOf (const MergedPlanes& merged)
{
  std::vector<Plane> planes;
  planes.reserve (merged.fits.size());
  for (const PlaneFit& fit : merged.fits)
    planes.push_back (fit.plane);
  return planes;
}

MergedPlanes
refitAssigned (const Points& points,
               Labels& labels,
               const MergedPlanes& merged,
               const MergingParameters& parameters,
               unsigned threads)
{
  MergedPlanes refitted =
      mergeLabelled (points, labels, merged.fits.size(), parameters, threads);
  Labels merged_into = merged.merged_into;
  relabel (merged_into, refitted.merged_into, threads);
  refitted.merged_into = std::move (merged_into);
  return refitted;
}

} // namespace pcl_ops

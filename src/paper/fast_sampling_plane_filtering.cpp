// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/stage_clock.h"
#include "detection/labeled_planes.h"
#include "paper/local_plane_sampling.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>

#include <cmath>
#include <string>
#include <utility>

namespace pcl_ops {

detail::Detection
detail::detect (const DetectorInput& input,
                const FastSamplingPlaneFilteringParameters& parameters)
{
  using namespace internal;
  const auto detectBySpheres = [&] (const Points& points, StageDurations& durations) {
    const FastSamplingPlaneFilteringParameters::Local& local = parameters.local;
    const double theta_h = *parameters.distance_threshold;
    const MergingParameters merging = mergingOf (parameters);
    StageClock clock;
    const Spheres spheres =
        spheresAround (input, points, local.outer_radius, parameters.threads);
    clock.lap (durations.search);
    // Symbols and sections in these comments are those of the paper on OPS.
    // Pi: planes of spheres that pass the local test
    const LocalPlanes sampled = sampleLocalPlanes (
        spheres.points, spheres.find, local, theta_h, parameters.seed);
    clock.lap (durations.extraction);
    // section III-C: merges planes by the coplanarity test on each pair
    const MergedPlanes merged = mergePlanes (sampled.moments, merging);
    clock.lap (durations.merging);
    // assigns all points of P, not only those in spheres, to the largest plane within
    // theta_h; merged planes are sorted, the largest first
    std::vector<Plane> planes;
    for (const PlaneFit& fit : merged.fits)
      planes.push_back (fit.plane);
    AssignedPoints assigned = assignToUnboundedPlanes (
        points, planes, theta_h, AssignmentRule::First, parameters.threads);
    clock.lap (durations.assignment);
    // fits the planes to their points, and merges planes that have become coplanar
    LabeledPlanes found =
        mergePlanesOf (std::move (assigned), merging, parameters.threads);
    found.planes_before_merging = sampled.moments.size();
    clock.lap (durations.merging);
    return found;
  };
  return detectInFinitePoints (input, parameters, detectBySpheres);
}

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

std::string
validate (const FastSamplingPlaneFilteringParameters& parameters)
{
  constexpr unsigned points_of_a_plane = 3;
  const FastSamplingPlaneFilteringParameters::Local& local = parameters.local;
  const auto isAboveZero = [] (double value) {
    return value > 0.0 && std::isnormal (value);
  };
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
  if (!parameters.distance_threshold)
    return "the distance threshold must be a length above 0";
  return validate (static_cast<const PlaneDetectorParameters&> (parameters));
}

} // namespace pcl_ops

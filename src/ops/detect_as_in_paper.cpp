// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/detect_as_in_paper.h"

#include "ops/point_extraction.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl_ops::internal {

namespace {

RansacParameters
ransacParameters (const OrientedPointSamplingParameters& parameters)
{
  constexpr unsigned fewest = 2; // more than two: three samples make a plane
  RansacParameters ransac;
  ransac.distance_threshold = *parameters.distance_threshold;
  ransac.min_inliers = std::max (fewest, parameters.min_inliers);
  ransac.probability = parameters.paper_only.probability;
  ransac.local_optimization = parameters.paper_only.local_optimization;
  return ransac;
}

std::vector<Indices>
groupsOf (const OrientedSamples& samples,
          const OrientedPointSamplingParameters& parameters)
{
  if (parameters.paper_only.strategy == PaperParameters::Strategy::DivideThenDetect) {
    const auto groups =
        groupByOrientation (samples,
                            parameters.up_axis.cast<double>().normalized(),
                            parameters.angle_tolerance);
    return {groups.begin(), groups.end()};
  }
  Indices all (samples.size());
  std::iota (all.begin(), all.end(), 0);
  return {all};
}

} // namespace

std::vector<Plane>
extractPlanes (const Points& points,
               const OrientedSamples& samples,
               const OrientedPointSamplingParameters& parameters)
{
  const RansacParameters ransac = ransacParameters (parameters);
  RandomGenerator generator (parameters.seed);
  const bool on_all_points =
      parameters.paper_only.verification == PaperParameters::Verification::AllPoints;
  Coordinates remaining = on_all_points ? Coordinates (points) : Coordinates();
  std::vector<Plane> planes;
  for (Indices& group : groupsOf (samples, parameters)) {
    Candidates candidates{samples, std::move (group)};
    if (on_all_points)
      candidates.remaining = &remaining;
    for (const ExtractedPlane& found : extractAll (candidates, ransac, generator))
      planes.push_back (found.plane);
  }
  return planes;
}

LabelledPlanes
detectAsInPaper (const DetectorInput& input,
                 const Points& points,
                 const OrientedPointSamplingParameters& parameters,
                 StageDurations& durations)
{
  StageClock clock;
  // P_s: alpha_s N of the points
  const Indices drawn =
      drawSample (points.size(), parameters.sampling_rate, parameters.seed);
  NeighborSearch search;
  if (!drawn.empty())
    search = searchOver (input, points, parameters.threads);
  clock.lap (durations.search);
  // n_i: from the k nearest points
  const OrientedSamples samples = orientSamples (input.cloud,
                                                 points,
                                                 drawn,
                                                 search,
                                                 parameters.k,
                                                 parameters.paper_only.normal_sigma);
  clock.lap (durations.normals);
  // Pi: one-point RANSAC and peeling, with theta_h, theta_N and p
  const std::vector<Plane> planes = extractPlanes (points, samples, parameters);
  clock.lap (durations.extraction);
  // every point of P, not of P_s alone, to a plane
  AssignedPoints assigned =
      assignToUnboundedPlanes (points,
                               planes,
                               *parameters.distance_threshold,
                               parameters.paper_only.assignment_rule,
                               parameters.threads);
  clock.lap (durations.assignment);
  // section III-C: the coplanarity test on each pair
  LabelledPlanes found =
      mergeAssigned (std::move (assigned), mergingOf (parameters), parameters.threads);
  clock.lap (durations.merging);
  return found;
}

} // namespace pcl_ops::internal

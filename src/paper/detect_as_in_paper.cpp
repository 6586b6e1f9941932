// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/detect_as_in_paper.h"

#include "geometry/angles.h"
#include "paper/point_extraction.h"

#include <algorithm>
#include <utility>

namespace pcl_ops::internal {

std::vector<Plane>
extractPlanes (const Points& points,
               const OrientedSamples& samples,
               const OrientedPointSamplingParameters& parameters)
{
  constexpr unsigned fewest = 2; // more than two: three samples make a plane
  RansacParameters ransac = parameters;
  ransac.min_samples = std::max (fewest, parameters.min_samples);
  RandomGenerator generator (parameters.seed);
  const PaperParameters& paper = parameters.paper_only;
  const bool on_all_points =
      paper.verification == PaperParameters::Verification::AllPoints;
  Coordinates remaining = on_all_points ? Coordinates (points) : Coordinates();
  // Strategy 1 has one group: within a right angle all samples are horizontal.
  const bool divides = paper.strategy == PaperParameters::Strategy::DivideThenDetect;
  std::vector<Plane> planes;
  for (Indices& group :
       groupByOrientation (samples,
                           parameters.up_axis.cast<double>().normalized(),
                           divides ? parameters.angle_tolerance : right_angle)) {
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
      mergePlanesOf (std::move (assigned), mergingOf (parameters), parameters.threads);
  clock.lap (durations.merging);
  return found;
}

} // namespace pcl_ops::internal

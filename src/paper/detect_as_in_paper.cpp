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
  // A plane needs more samples than min_samples (theta_N), and three to be fitted.
  constexpr unsigned lowest_theta_n = 2;
  RansacParameters ransac = parameters;
  ransac.min_samples = std::max (lowest_theta_n, parameters.min_samples);
  RandomGenerator generator (parameters.seed);
  const PaperParameters& paper = parameters.paper_only;
  const bool on_all_points =
      paper.verification == PaperParameters::Verification::AllPoints;
  Coordinates free_points; // points on no plane yet, if hypotheses are verified on all
  if (on_all_points)
    free_points = points;
  // Strategy 2 divides samples into groups. Strategy 1 searches all samples at once:
  // with a right angle as tolerance all of them are in the horizontal group.
  const bool divides = paper.strategy == PaperParameters::Strategy::DivideThenDetect;
  const double group_tolerance = divides ? parameters.angle_tolerance : right_angle;
  std::vector<Plane> planes;
  for (Indices& group : groupByOrientation (
           samples, parameters.up_axis.cast<double>().normalized(), group_tolerance)) {
    Candidates candidates{samples, std::move (group)};
    if (on_all_points)
      candidates.free_points = &free_points;
    for (const ExtractedPlane& found : extractAll (candidates, ransac, generator))
      planes.push_back (found.plane);
  }
  return planes;
}

LabeledPlanes
detectAsInPaper (const DetectorInput& input,
                 const Points& points,
                 const OrientedPointSamplingParameters& parameters,
                 StageDurations& durations)
{
  // Symbols and sections in these comments are those of the paper.
  StageClock clock;
  // P_s: alpha_s N points drawn at random
  const Indices drawn =
      drawSample (points.size(), parameters.sampling_rate, parameters.seed);
  NeighborSearch search;
  if (!drawn.empty())
    search = searchOver (input, points, parameters.threads);
  clock.lap (durations.search);
  // n_i: normals from the k nearest neighbors
  const OrientedSamples samples = orientSamples (input.cloud,
                                                 points,
                                                 drawn,
                                                 search,
                                                 parameters.k,
                                                 parameters.paper_only.normal_sigma);
  clock.lap (durations.normals);
  // Pi: planes by one-point RANSAC, one by one, with theta_h, theta_N and p
  const std::vector<Plane> planes = extractPlanes (points, samples, parameters);
  clock.lap (durations.extraction);
  // assigns all points of P, not only P_s, to planes
  AssignedPoints assigned =
      assignToUnboundedPlanes (points,
                               planes,
                               *parameters.distance_threshold,
                               parameters.paper_only.assignment_rule,
                               parameters.threads);
  clock.lap (durations.assignment);
  // section III-C: merges planes by the coplanarity test on each pair
  LabeledPlanes found =
      mergePlanesOf (std::move (assigned), mergingOf (parameters), parameters.threads);
  clock.lap (durations.merging);
  return found;
}

} // namespace pcl_ops::internal

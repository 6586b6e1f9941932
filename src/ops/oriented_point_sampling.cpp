// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl_ops {

OrientedPointSamplingParameters
OrientedPointSamplingParameters::paper()
{
  OrientedPointSamplingParameters parameters;
  parameters.sampling = Sampling::Points;
  parameters.sampling_rate = 0.03;
  parameters.normals.k = 30;
  parameters.normals.sigma = 0.0;
  parameters.distance_threshold = 0.05;
  parameters.min_inliers = 20;
  parameters.probability = 0.99;
  parameters.strategy = Strategy::DivideThenDetect;
  parameters.verification = Verification::Samples;
  parameters.local_optimisation = false;
  parameters.merging.noise_factor = 0.0;
  return parameters;
}

std::string
problemOf (const OrientedPointSamplingParameters& parameters)
{
  if (!(parameters.sampling_rate > 0.0 && parameters.sampling_rate <= 1.0))
    return "the sampling rate must be above 0 and at most 1";
  if (parameters.normals.k < 2)
    return "k must be 2 or more: a normal needs two neighbours";
  if (!(parameters.normals.sigma >= 0.0 && std::isfinite (parameters.normals.sigma)))
    return "the sigma of the normals must be 0 (adaptive) or a length";
  if (!(parameters.probability > 0.0 && parameters.probability < 1.0))
    return "the probability must lie between 0 and 1, both excluded";
  return problemOf (static_cast<const PlaneDetectorParameters&> (parameters),
                    parameters.sampling == Sampling::Cells);
}

RansacParameters
ransacParameters (const OrientedPointSamplingParameters& parameters)
{
  constexpr unsigned fewest = 2; // more than two: three samples make a plane
  RansacParameters ransac;
  ransac.distance_threshold = parameters.distance_threshold;
  ransac.min_inliers = std::max (fewest, parameters.min_inliers);
  ransac.probability = parameters.probability;
  ransac.local_optimisation = parameters.local_optimisation;
  return ransac;
}

namespace {

std::vector<Positions>
groupsOf (const OrientedSamples& samples,
          const OrientedPointSamplingParameters& parameters)
{
  if (parameters.strategy == Strategy::DivideThenDetect) {
    const auto groups =
        groupByOrientation (samples,
                            parameters.up_axis.cast<double>().normalized(),
                            parameters.angle_tolerance);
    return {groups.begin(), groups.end()};
  }
  Positions all (samples.size());
  std::iota (all.begin(), all.end(), 0);
  return {all};
}

} // namespace

std::vector<Plane>
extractPlanes (const OrientedSamples& samples,
               const Points& points,
               const OrientedPointSamplingParameters& parameters)
{
  const bool on_all_points = parameters.verification == Verification::AllPoints;
  const RansacParameters ransac = ransacParameters (parameters);
  RandomGenerator generator (parameters.seed);
  Coordinates remaining = on_all_points ? Coordinates (points) : Coordinates();
  const auto find_largest = [&] (const Positions& candidates) {
    return on_all_points
               ? largestPlane (samples, candidates, remaining, ransac, generator)
               : largestPlane (samples, candidates, ransac, generator);
  };
  std::vector<ExtractedPlane> extracted;
  for (const Positions& group : groupsOf (samples, parameters))
    for (ExtractedPlane& found : extractAll (group, find_largest))
      extracted.push_back (std::move (found));
  std::vector<Plane> planes;
  for (const ExtractedPlane& found : extracted)
    planes.push_back (found.plane);
  return planes;
}

} // namespace pcl_ops

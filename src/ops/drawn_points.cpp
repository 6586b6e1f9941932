// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/drawn_points.h"

#include "detection/merging_defaults.h"
#include "detection/neighbour_search.h"
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
  ransac.probability = parameters.probability;
  ransac.local_optimisation = parameters.local_optimisation;
  return ransac;
}

std::vector<Indices>
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
  Indices all (samples.size());
  std::iota (all.begin(), all.end(), 0);
  return {all};
}

} // namespace

DrawnPoints::Samples
DrawnPoints::sample (const Points& points) const
{
  Samples samples;
  samples.points =
      drawSample (points.size(), parameters_.sampling_rate, parameters_.seed);
  if (!samples.points.empty())
    samples.search = searchOver (input_, points, parameters_.threads);
  return samples;
}

OrientedSamples
DrawnPoints::orient (const Points& points, const Samples& samples) const
{
  return orientSamples (input_.cloud,
                        points,
                        samples.points,
                        samples.search,
                        parameters_.k,
                        parameters_.normal_sigma);
}

std::vector<Plane>
DrawnPoints::extract (const Points& points,
                      const Samples& /*samples*/,
                      const OrientedSamples& oriented) const
{
  const RansacParameters ransac = ransacParameters (parameters_);
  RandomGenerator generator (parameters_.seed);
  const bool on_all_points = parameters_.verification == Verification::AllPoints;
  Coordinates remaining = on_all_points ? Coordinates (points) : Coordinates();
  std::vector<Plane> planes;
  for (Indices& group : groupsOf (oriented, parameters_)) {
    PointCandidates candidates (oriented, std::move (group), ransac);
    if (on_all_points)
      candidates.verifyOn (remaining);
    for (const ExtractedPlane& found :
         extractAll (candidates, [&] (const PointCandidates& left) {
           return largestPlane (left, ransac, generator);
         }))
      planes.push_back (found.plane);
  }
  return planes;
}

AssignedPoints
DrawnPoints::assign (const Points& points,
                     const Samples& /*samples*/,
                     const std::vector<Plane>& planes) const
{
  return assignToUnboundedPlanes (points,
                                  planes,
                                  *parameters_.distance_threshold,
                                  parameters_.assignment_rule,
                                  parameters_.threads);
}

LabelledPlanes
DrawnPoints::merge (AssignedPoints assigned) const
{
  return mergeAssigned (
      std::move (assigned), mergingOf (parameters_), parameters_.threads);
}

} // namespace pcl_ops::internal

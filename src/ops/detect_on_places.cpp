// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/detect_on_places.h"

#include "ops/place_parameters.h"
#include "ops/planes_of_regions.h"
#include "ops/region_evidence.h"
#include "ops/region_joining.h"
#include "ops/stage_reports.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace pcl_ops::internal {

LabeledPlanes
detectOnPlaces (const Points& points,
                const OrientedPointSamplingParameters& parameters,
                StageDurations& times)
{
  const unsigned threads = parameters.threads;
  StageClock clock;

  const DistinctPlaces distinct = distinctPlaces (points, threads);
  if (distinct.size() < min_places || drawsNothing (parameters, points.size()))
    return {Labels (points.size(), no_plane), {}};
  const StageReports report (parameters.on_stage, distinct.of_input);
  const Places places = describePlaces (
      distinct, neighborhoodSizeFor (parameters, distinct.size()), threads);
  report (Stage::Density, places.density);
  clock.lap (times.search);

  const PlaceNoise noise = noiseOfPlaces (places, parameters.noise_of_whole, threads);
  report (Stage::Noise, noise.of_place);
  const ChosenSupports chosen = chooseSupports (places, noise, threads);
  report (Stage::Supports, chosen.width, chosen.is_flat);
  clock.lap (times.normals);

  Regions regions = growRegions (places, noise, chosen, parameters.distance_threshold);
  report (Stage::Regions, regions.of_place);
  clock.lap (times.extraction);
  // This replaces the merging of the paper, section III-C: distances are compared with
  // the noise instead of theta_h.
  joinTouching (places, threads, regions);
  if (parameters.merging.enabled)
    joinOverGaps (parameters.merging, regions);
  report (Stage::Joined, regions.of_place);
  const std::vector<char> is_plane = planesAmong (
      places, noise, chosen, regions, minPointsFactor (parameters), threads);
  report (Stage::Planes, regions.of_place, is_plane);
  clock.lap (times.merging);

  LabeledPlanes found =
      planesOfRegions (points, distinct, places, noise, regions, is_plane, parameters);
  found.planes_before_merging = regions.list.size();
  clock.lap (times.assignment);
  return found;
}

CloudNoise
noiseOfCloud (const Points& points,
              const OrientedPointSamplingParameters& parameters,
              std::size_t points_of_whole)
{
  const DistinctPlaces distinct = distinctPlaces (points, parameters.threads);
  if (distinct.size() < min_places)
    return {};
  // The size of the whole cloud determines the neighborhoods of its parts:
  // neighborhoodSizeFor reads it from noise_of_whole.
  OrientedPointSamplingParameters of_whole = parameters;
  of_whole.noise_of_whole.emplace();
  of_whole.noise_of_whole->points =
      static_cast<double> (std::max (distinct.size(), points_of_whole));
  const Places places = describePlaces (
      distinct, neighborhoodSizeFor (of_whole, distinct.size()), parameters.threads);
  CloudNoise noise = noiseOfPlaces (places, std::nullopt, parameters.threads).cloud;
  noise.points = of_whole.noise_of_whole->points;
  return noise;
}

} // namespace pcl_ops::internal

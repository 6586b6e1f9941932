// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/detect_on_places.h"

#include "detection/plane_assignment.h"
#include "detection/plane_layers.h"
#include "places/constants.h"
#include "places/region_evidence.h"
#include "places/region_joining.h"
#include "places/region_labels.h"
#include "voxels/distinct_places.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

namespace {

using OpsParameters = OrientedPointSamplingParameters;

// Fewer places are no plane.
constexpr std::size_t min_places = 6;

// By how much the nearest points are more than usual: larger neighborhoods have
// smoother normals, more samples find smaller planes.
double
neighborsFactor (const OpsParameters& parameters)
{
  constexpr double usual_k = 30.0;
  constexpr double usual_rate = 0.03;
  return parameters.k / usual_k * std::sqrt (usual_rate / parameters.sampling_rate);
}

// theta_N: over the usual one.
double
minPointsFactor (const OpsParameters& parameters)
{
  constexpr double usual_samples = 20.0;
  constexpr double usual_rate = 0.03;
  return parameters.min_samples / usual_samples * usual_rate / parameters.sampling_rate;
}

// The two sides of a wall that is thinner than its noise lets regions tell are planes
// of their own.
void
splitLayers (const Coordinates& places,
             const Regions& regions,
             std::optional<double> distance_threshold,
             Labels& labels,
             std::vector<char>& is_plane)
{
  // Supports that mix the layers scatter by half of what they are apart.
  constexpr double noises_apart = 1.7;
  std::vector<Plane> planes;
  std::vector<double> min_apart;
  for (const Region& region : regions.list) {
    planes.push_back (region.fit.plane);
    min_apart.push_back (
        std::max (noises_apart * region.noise, distance_threshold.value_or (0.0)));
  }
  splitLayers (places, planes, min_apart, labels, is_plane);
}

// The labels of all points of the cloud, of planes that are kept.
AssignedPoints
labelCloud (const Points& points,
            const DistinctPlaces& distinct,
            const Labels& labels,
            const std::vector<char>& is_kept,
            unsigned threads)
{
  Labels number (is_kept.size(), no_plane);
  std::int32_t planes = 0;
  for (std::size_t p = 0; p < is_kept.size(); ++p)
    if (is_kept[p] != 0)
      number[p] = planes++;
  AssignedPoints assigned;
  assigned.labels.resize (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int32_t plane = labels[distinct.of_input[i]];
    assigned.labels[i] = plane == no_plane ? no_plane : number[plane];
  }
  assigned.moments = momentsOfLabels (
      points, assigned.labels, static_cast<std::size_t> (planes), threads);
  return assigned;
}

// Planes of a distance that a user gave are one, too.
LabelledPlanes
merge (AssignedPoints assigned, const OpsParameters& parameters)
{
  MergingParameters given = parameters.merging;
  given.enabled = given.enabled && given.distance_threshold.has_value();
  return mergeAssigned (std::move (assigned), given, parameters.threads);
}

// The noise of each plane, the median over its points; unknown of exact ones.
void
tellNoises (const DistinctPlaces& distinct,
            const PlaceNoise& noise,
            LabelledPlanes& found)
{
  std::vector<std::vector<float>> noises (found.planes.fits.size());
  for (std::size_t i = 0; i < found.labels.size(); ++i)
    if (found.labels[i] != no_plane)
      noises[found.labels[i]].push_back (noise.of_place[distinct.of_input[i]]);
  std::vector<float> medians;
  for (std::vector<float>& of_plane : noises) {
    const double median = medianOf (of_plane);
    found.noises.push_back (median > 0.0 ? std::optional (median) : std::nullopt);
    medians.push_back (static_cast<float> (median));
  }
  if (!medians.empty())
    found.used.distance_threshold =
        place_constants.noises_of_point * medianOf (medians);
}

// Planes of regions: those for which more speaks than against them.
LabelledPlanes
planesOfRegions (const Points& points,
                 const DistinctPlaces& distinct,
                 const Places& places,
                 const PlaceNoise& noise,
                 const Regions& regions,
                 std::vector<char> is_plane,
                 const OpsParameters& parameters)
{
  Labels labels = labelPlaces (places,
                               noise,
                               regions,
                               is_plane,
                               parameters.distance_threshold,
                               parameters.threads);
  splitLayers (distinct, regions, parameters.distance_threshold, labels, is_plane);
  LabelledPlanes found = merge (
      labelCloud (points, distinct, labels, is_plane, parameters.threads), parameters);
  tellNoises (distinct, noise, found);
  if (parameters.distance_threshold)
    found.used.distance_threshold = parameters.distance_threshold;
  return found;
}

} // namespace

LabelledPlanes
detectOnPlaces (const Points& points,
                const OpsParameters& parameters,
                StageDurations& times)
{
  const unsigned threads = parameters.threads;
  LabelledPlanes found;
  found.labels.assign (points.size(), no_plane);
  StageClock clock;
  // P: each place once, in an order of its own
  const DistinctPlaces distinct = distinctPlaces (points, threads);
  if (distinct.size() < min_places)
    return found;
  // k: the nearest points of each, and what larger supports are like
  const Places places =
      describePlaces (distinct,
                      neighborsOfCloud (distinct.size(), neighborsFactor (parameters)),
                      threads);
  clock.lap (times.search);
  // n_i: normals of the largest supports that the noise explains
  const PlaceNoise noise = noiseOfPlaces (places, threads);
  const ChosenSupports chosen = chooseSupports (places, noise, threads);
  clock.lap (times.normals);
  // Pi: regions from the flattest places on
  Regions regions = growRegions (places, noise, chosen, parameters.distance_threshold);
  clock.lap (times.extraction);
  // section III-C, by the noise instead of theta_h
  joinTouching (places, regions);
  if (parameters.merging.enabled)
    joinOverGaps (noise, parameters.merging, regions);
  const std::vector<char> is_plane = planesAmong (
      places, noise, chosen, regions, minPointsFactor (parameters), threads);
  clock.lap (times.merging);
  // every point of P to a plane
  found =
      planesOfRegions (points, distinct, places, noise, regions, is_plane, parameters);
  found.planes_before_merging = regions.list.size();
  clock.lap (times.assignment);
  return found;
}

} // namespace pcl_ops::internal

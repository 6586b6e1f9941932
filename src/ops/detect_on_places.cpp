// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/detect_on_places.h"

#include "detection/plane_assignment.h"
#include "detection/plane_layers.h"
#include "ops/stage_reports.h"
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
  constexpr double power = 0.25;
  return parameters.k / usual_k *
         std::pow (usual_rate / parameters.sampling_rate, power);
}

// theta_N: over the usual one.
double
minPointsFactor (const OpsParameters& parameters)
{
  constexpr double usual_samples = 20.0;
  return parameters.min_samples / usual_samples;
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

// No plane is thicker than its noise says: hills are joined of pieces each of which is
// thin. What is exact for its width is none.
void
dropThick (const Coordinates& places,
           const PlaceNoise& noise,
           const Labels& labels,
           unsigned threads,
           std::vector<char>& is_plane)
{
  const std::vector<Moments> moments =
      momentsOfLabels (places, labels, is_plane.size(), threads);
  std::vector<std::vector<float>> noises (is_plane.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != no_plane)
      noises[labels[i]].push_back (noise.of_place[i]);
  for (std::size_t p = 0; p < is_plane.size(); ++p) {
    const std::optional<PlaneFit> fit =
        is_plane[p] != 0 && moments[p].count >= min_places ? fitPlane (moments[p])
                                                           : std::nullopt;
    if (!fit)
      continue;
    const double width = std::sqrt (squared_width_of_variance * fit->variances[1]);
    const double limit =
        std::max (place_constants.max_noises_of_plane * medianOf (noises[p]),
                  place_constants.max_exact * width);
    if (fit->variances[0] > limit * limit)
      is_plane[p] = 0;
  }
}

// The labels of all points of the cloud, of planes that are kept.
AssignedPoints
labelPointsOf (const Points& points,
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
mergeByGivenDistance (AssignedPoints assigned, const OpsParameters& parameters)
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
  if (!parameters.distance_threshold)
    dropThick (distinct, noise, labels, parameters.threads, is_plane);
  LabelledPlanes found = mergeByGivenDistance (
      labelPointsOf (points, distinct, labels, is_plane, parameters.threads),
      parameters);
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
  // alpha_s: a share that is far from drawing a point finds none
  constexpr double least_drawn = 0.1;
  if (distinct.size() < min_places ||
      parameters.sampling_rate * static_cast<double> (points.size()) < least_drawn)
    return found;
  const StageReports report (parameters.on_stage, distinct.of_input);
  // k: the nearest points of each, and what larger supports are like
  const Places places =
      describePlaces (distinct,
                      neighborsOfCloud (distinct.size(), neighborsFactor (parameters)),
                      threads);
  report (Stage::Density, places.density);
  clock.lap (times.search);
  // n_i: normals of the largest supports that the noise explains
  const PlaceNoise noise = noiseOfPlaces (places, threads);
  report (Stage::Noise, noise.of_place);
  const ChosenSupports chosen = chooseSupports (places, noise, threads);
  report (Stage::Supports, chosen.width, chosen.is_flat);
  clock.lap (times.normals);
  // Pi: regions from the flattest places on
  Regions regions = growRegions (places, noise, chosen, parameters.distance_threshold);
  report (Stage::Regions, regions.of_place);
  clock.lap (times.extraction);
  // section III-C, by the noise instead of theta_h
  joinTouching (places, threads, regions);
  if (parameters.merging.enabled)
    joinOverGaps (noise, parameters.merging, regions);
  report (Stage::Joined, regions.of_place);
  const std::vector<char> is_plane = planesAmong (
      places, noise, chosen, regions, minPointsFactor (parameters), threads);
  report (Stage::Planes, regions.of_place, is_plane);
  clock.lap (times.merging);
  // every point of P to a plane
  found =
      planesOfRegions (points, distinct, places, noise, regions, is_plane, parameters);
  found.planes_before_merging = regions.list.size();
  clock.lap (times.assignment);
  return found;
}

} // namespace pcl_ops::internal

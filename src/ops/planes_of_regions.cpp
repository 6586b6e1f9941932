// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/planes_of_regions.h"

#include "cloud/coordinate_steps.h"
#include "detection/plane_assignment.h"
#include "detection/plane_layers.h"
#include "ops/constants.h"
#include "ops/place_parameters.h"
#include "ops/region_labels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace pcl_ops::internal {

namespace {

// Whether a place has a twin: a neighbor one coordinate step away along the axis
// nearest to a normal.
// \param[in] steps of rounded coordinates along x, y and z [m]
bool
hasTwin (const Places& places,
         std::size_t place,
         const Eigen::Vector3d& normal,
         const Eigen::Vector3d& steps)
{
  constexpr double tolerance = 0.1; // in steps; chosen by hand
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff (&axis);
  const std::uint32_t* const nearest = places.nearestOf (place);
  return std::any_of (
      nearest, nearest + places.neighbors_per_place, [&] (std::uint32_t other) {
        Eigen::Vector3d deviation =
            (places.position[other] - places.position[place]).cwiseAbs();
        deviation[axis] -= steps[axis];
        return deviation.lpNorm<Eigen::Infinity>() < tolerance * steps[axis];
      });
}

// Returns for each region the step of rounded coordinates along its normal [m]:
// rounding puts the places of a surface into layers that are one step apart. The step
// is 0 if coordinates were not rounded.
//
// The step is also 0 for a thin body whose points lie on an exact grid: its layers are
// its two sides, which splitThinWalls may separate. In such a body nearly every place
// has a twin (hasTwin) on the other side. Rounding a single surface puts each place
// into only one layer.
// \param[in] distinct coordinates of the places
std::vector<double>
roundingSteps (const Coordinates& distinct,
               const Places& places,
               const Regions& regions)
{
  constexpr double min_share_of_twins = 0.9; // chosen by hand: nearly every place
  std::vector<double> step_of_region (regions.list.size(), 0.0);
  const Eigen::Vector3d steps = coordinateSteps (distinct); // along x, y and z [m]
  if (steps.isZero (0.0))
    return step_of_region;
  // For each region how many of its places have a twin.
  std::vector<double> twins (step_of_region.size(), 0.0);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const std::int32_t region = regions.of_place[i]; region != no_plane)
      twins[region] +=
          hasTwin (places, i, regions.list[region].fit.plane.normal, steps) ? 1.0 : 0.0;
  for (std::size_t r = 0; r < step_of_region.size(); ++r) {
    const Region& region = regions.list[r];
    if (twins[r] < min_share_of_twins * region.moments.count)
      step_of_region[r] = region.fit.plane.normal.cwiseProduct (steps).norm();
  }
  return step_of_region;
}

// Splits each region that grew over both sides of a thin wall into two planes. The new
// planes have the indices after the last region.
// \param[in] distinct coordinates of the places
// \param[in,out] labels of the places: indices of their planes
// \param[in,out] is_plane for each region; each new plane adds a 1
void
splitThinWalls (const Coordinates& distinct,
                const Places& places,
                const Regions& regions,
                std::optional<double> distance_threshold,
                Labels& labels,
                std::vector<char>& is_plane)
{
  // Least distance of the sides, in units of the noise. It is below 2: noise that was
  // measured over both sides of a wall is half of their distance.
  constexpr double noises_apart = 1.7; // chosen by hand
  // The same in steps of rounded coordinates. It is above 1, as rounding alone makes
  // layers that are one step apart, and below 2, the distance of sides two steps apart.
  constexpr double steps_apart = 1.5;
  const std::vector<double> step_of_region = roundingSteps (distinct, places, regions);
  std::vector<Plane> planes;
  std::vector<double> min_apart; // least distance of the sides of each region [m]
  for (std::size_t r = 0; r < regions.list.size(); ++r) {
    planes.push_back (regions.list[r].fit.plane);
    min_apart.push_back (std::max ({noises_apart * regions.list[r].noise,
                                    steps_apart * step_of_region[r],
                                    distance_threshold.value_or (0.0)}));
  }
  splitLayers (distinct, planes, min_apart, labels, is_plane);
}

// Returns for each plane the noises of all items with its label [m].
// \param[in] labels of the items, places or points
// \param[in] planes number of planes
// \param[in] noiseOfItem called with the index of an item
template <typename NoiseOfItem>
std::vector<std::vector<float>>
noisesOfPlanes (const Labels& labels,
                std::size_t planes,
                const NoiseOfItem& noiseOfItem)
{
  std::vector<std::vector<float>> noises (planes);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != no_plane)
      noises[labels[i]].push_back (noiseOfItem (i));
  return noises;
}

// Drops planes whose rms distance is far above their noise, such as hills joined from
// thin pieces. If the noise is near 0, the limit is max_exact_thickness times the
// width.
// \param[in] distinct coordinates of the places
// \param[in] labels of the places
void
dropThickPlanes (const Coordinates& distinct,
                 const PlaceNoise& noise,
                 const Labels& labels,
                 unsigned threads,
                 std::vector<char>& is_plane)
{
  const std::vector<Moments> moments =
      momentsOfLabels (distinct, labels, is_plane.size(), threads);
  std::vector<std::vector<float>> noises =
      noisesOfPlanes (labels, is_plane.size(), [&] (std::size_t place) {
        return noise.of_place[place];
      });
  for (std::size_t p = 0; p < is_plane.size(); ++p) {
    if (is_plane[p] == 0 || moments[p].count < min_places)
      continue;
    const std::optional<PlaneFit> fit = fitPlane (moments[p]);
    if (!fit)
      continue;
    const double width = std::sqrt (squared_width_of_variance * fit->variances[1]);
    const double max_rms =
        std::max (place_constants.max_noises_of_plane * medianOf (noises[p]),
                  place_constants.max_exact_thickness * width);
    if (fit->variances[0] > max_rms * max_rms)
      is_plane[p] = 0;
  }
}

// Gives each point of the cloud the label of its place. The planes that are kept get
// successive labels from 0 on; other places get no_plane.
AssignedPoints
labelPointsOf (const Points& points,
               const DistinctPlaces& distinct,
               const Labels& label_of_place,
               const std::vector<char>& is_kept,
               unsigned threads)
{
  Labels new_label (is_kept.size(), no_plane);
  std::int32_t planes = 0;
  for (std::size_t p = 0; p < is_kept.size(); ++p)
    if (is_kept[p] != 0)
      new_label[p] = planes++;
  AssignedPoints assigned;
  assigned.labels.resize (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int32_t label = label_of_place[distinct.of_input[i]];
    assigned.labels[i] = label == no_plane ? no_plane : new_label[label];
  }
  assigned.moments = momentsOfLabels (
      points, assigned.labels, static_cast<std::size_t> (planes), threads);
  return assigned;
}

// Fits planes to the assigned points. Merges planes only if the user gave a merging
// distance: without one, the joins of regions replace the merging.
LabeledPlanes
fitAndMerge (AssignedPoints assigned, const OrientedPointSamplingParameters& parameters)
{
  MergingParameters given = parameters.merging;
  given.noise_factor.reset(); // limits only joins over gaps
  given.enabled = given.enabled && given.distance_threshold.has_value();
  return mergePlanesOf (std::move (assigned), given, parameters.threads);
}

// Sets the noise of each plane: the median over its points, unknown if that is 0. Sets
// the used distance threshold to noises_of_point times the median noise of the planes.
void
setNoises (const DistinctPlaces& distinct,
           const PlaceNoise& noise,
           LabeledPlanes& found)
{
  std::vector<std::vector<float>> noises =
      noisesOfPlanes (found.labels, found.planes.fits.size(), [&] (std::size_t point) {
        return noise.of_place[distinct.of_input[point]];
      });
  std::vector<float> medians;
  for (std::vector<float>& noises_of_plane : noises) {
    const double median = medianOf (noises_of_plane);
    found.noises.push_back (median > 0.0 ? std::optional (median) : std::nullopt);
    medians.push_back (static_cast<float> (median));
  }
  if (!medians.empty())
    found.used.distance_threshold =
        place_constants.noises_of_point * medianOf (medians);
}

} // namespace

LabeledPlanes
planesOfRegions (const Points& points,
                 const DistinctPlaces& distinct,
                 const Places& places,
                 const PlaceNoise& noise,
                 const Regions& regions,
                 std::vector<char> is_plane,
                 const OrientedPointSamplingParameters& parameters)
{
  Labels labels = labelPlaces (places,
                               noise,
                               regions,
                               is_plane,
                               parameters.distance_threshold,
                               parameters.threads);
  splitThinWalls (
      distinct, places, regions, parameters.distance_threshold, labels, is_plane);
  if (!parameters.distance_threshold)
    dropThickPlanes (distinct, noise, labels, parameters.threads, is_plane);
  LabeledPlanes found = fitAndMerge (
      labelPointsOf (points, distinct, labels, is_plane, parameters.threads),
      parameters);
  setNoises (distinct, noise, found);
  if (parameters.distance_threshold)
    found.used.distance_threshold = parameters.distance_threshold;
  return found;
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/detect_on_leaves.h"

#include "leaves/common_errors.h"
#include "leaves/evidence_joining.h"
#include "leaves/leaf_growing.h"
#include "leaves/leaf_halving.h"
#include "leaves/leaf_joining.h"
#include "leaves/leaf_labels.h"
#include "leaves/leaf_noise.h"
#include "leaves/leaf_spreading.h"
#include "leaves/plane_evidence.h"
#include "leaves/plane_layers.h"
#include "leaves/plane_splitting.h"
#include "leaves/surrounding_noise.h"
#include "ops/detect_on_voxels.h"
#include "ops/thin_planes.h"
#include "ops/voxel_choice.h"
#include "voxels/voxel_size.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

namespace {

using OpsParameters = OrientedPointSamplingParameters;

// A surfel's noise over its spread: of the first round, and of the last.
constexpr double first_max_thickness = 0.265;
constexpr double last_max_thickness = 0.3;
// Largest distance of a leaf's points while planes spread, and of a point to its plane,
// in units of the noise there.
constexpr double noises_of_a_leaf = 1.73;
constexpr double noises_of_a_point = 3.45;

/** \brief How finely a cloud is divided. */
struct OctreeSizes {
  double cell = 0.0; // edge of the finest cells [m]; 0: there is no surface
  LeafSizes leaves;
  double min_points_of_normal = 0.0;
  /** \brief Leaves a plane needs, over those of a large cloud. */
  double leaves_factor = 1.0;
};

constexpr double points_of_large_cloud = 300'000.0;

// Edge at which the cloud would fill as many leaves as are wanted, were they all of one
// size.
double
usualEdge (const Points& points, double sampling_rate)
{
  constexpr double min_points_per_leaf = 10.0;
  return voxelSizeFor (
      points, wantedVoxels (points.size(), sampling_rate, min_points_per_leaf));
}

// Sizes of leaves: given, or by the number of points.
OctreeSizes
octreeSizes (const Points& points, const OpsParameters& parameters)
{
  OctreeSizes sizes;
  if (const std::optional<double>& given = parameters.surfels.voxel_size) {
    // All leaves are of one size; the second round halves them.
    constexpr int level = 4;
    sizes.cell = std::ldexp (*given, -level);
    sizes.leaves.largest_level = level;
    sizes.leaves.smallest_level = level;
    return sizes;
  }
  constexpr int usual_level = 6;
  constexpr int smallest_level = 1;
  // Surveys in UTM and single precision lose their roofs if leaves have to be larger.
  constexpr double smallest_in_steps = 2.0;
  const double smallest = smallest_in_steps * singlePrecisionStep (points);
  const double edge = std::sqrt (2.0) * usualEdge (points, parameters.sampling_rate);
  sizes.cell = std::ldexp (edge > 0.0 ? std::max (edge, smallest) : 0.0, -usual_level);
  sizes.leaves.largest_level = usual_level + 1;
  sizes.leaves.smallest_level = smallest_level;
  // The second round halves leaves.
  while (std::ldexp (sizes.cell, sizes.leaves.smallest_level - 1) < smallest &&
         sizes.leaves.smallest_level < sizes.leaves.largest_level)
    ++sizes.leaves.smallest_level;
  return sizes;
}

// What depends on the number of different points.
void
adaptToPoints (std::size_t points, const OpsParameters& parameters, OctreeSizes& sizes)
{
  constexpr double usual_points_per_leaf = 45.0;
  constexpr double growth = 0.4;
  constexpr double min_points_per_leaf = 2.0;
  constexpr double usual_rate = 0.03;
  constexpr double points_of_small_cloud = 1000.0;
  const auto number = static_cast<double> (points);
  sizes.leaves.max_points =
      std::max (min_points_per_leaf,
                usual_points_per_leaf * (usual_rate / parameters.sampling_rate) *
                    std::pow (number / points_of_large_cloud, growth));
  // A fifth of k where points are few, more where leaves hold many.
  constexpr double least_share_of_k = 0.2;
  constexpr double share_of_leaf = 0.8;
  constexpr double usual_k = 30.0;
  sizes.min_points_of_normal =
      parameters.k *
      std::max (least_share_of_k, share_of_leaf / usual_k * sizes.leaves.max_points);
  // Fewer points offer fewer leaves that lie on a plane by chance.
  sizes.leaves_factor = std::min (1.0, std::cbrt (number / points_of_small_cloud));
}

/** \brief What all rounds share. */
struct Rounds {
  CurvePoints points;
  OctreeSizes sizes;
  std::vector<CellScatter> cells;
  ExpectedNoise expected;
  UnevenNoise uneven;
  CoordinateSteps steps;
  const OpsParameters& parameters;
};

/** \brief Adds the time until its end to a duration. */
class StageTime {
public:
  explicit StageTime (double& duration) : duration_ (duration) {}
  StageTime (const StageTime&) = delete;
  StageTime&
  operator= (const StageTime&) = delete;
  ~StageTime() { clock_.lap (duration_); }

private:
  double& duration_;
  StageClock clock_;
};

/** \brief What a stage returns; its time is added to a duration. */
template <typename Stage>
auto
timed (double& duration, const Stage& stage)
{
  const StageTime time (duration);
  return stage();
}

// P along a curve, where equal points count once, and what noise it shows.
Rounds
sortPoints (const Points& points, OctreeSizes sizes, const OpsParameters& parameters)
{
  CurvePoints sorted = sortAlongCurve (points, sizes.cell, parameters.threads);
  adaptToPoints (sorted.size(), parameters, sizes);
  std::vector<CellScatter> cells = scatterOfCells (sorted, parameters.threads);
  ExpectedNoise expected (cells, sorted.cell);
  UnevenNoise uneven (sorted, cells, sizes.leaves.largest_level + 1);
  CoordinateSteps steps (sorted);
  return {std::move (sorted),
          sizes,
          std::move (cells),
          std::move (expected),
          std::move (uneven),
          std::move (steps),
          parameters};
}

LeafCloud
measure (const Rounds& rounds, std::vector<Leaf> leaves)
{
  return measureLeaves (rounds.points,
                        rounds.expected,
                        rounds.steps,
                        std::move (leaves),
                        rounds.parameters.threads);
}

// P_s: the leaves of an octree.
std::vector<Leaf>
divide (const Rounds& rounds)
{
  return divideIntoLeaves (rounds.points, rounds.sizes.leaves, rounds.uneven);
}

// Whether neighboring points err alike in so much of the cloud that voxels of one size
// average their noise better: in images of depth cameras, not in lidar scans, surveys,
// fused meshes, CAD models (src/doc/decisions.md).
bool
prefersVoxels (const Rounds& rounds, const std::vector<Leaf>& leaves)
{
  constexpr double max_share_of_errors = 0.1;
  return shareOfCommonErrors (rounds.points, rounds.cells, rounds.expected, leaves) >
         max_share_of_errors;
}

// The labels of all points of the cloud, of planes that are kept.
AssignedPoints
labelCloud (const Points& points,
            const CurvePoints& sorted,
            const Labels& labels,
            const std::vector<char>& is_kept,
            unsigned threads)
{
  Labels number (is_kept.size(), no_plane);
  std::int32_t planes = 0;
  for (std::size_t p = 0; p < is_kept.size(); ++p)
    if (is_kept[p] != 0) {
      number[p] = planes;
      ++planes;
    }
  AssignedPoints assigned;
  assigned.labels.resize (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int32_t plane = labels[sorted.of_input[i]];
    assigned.labels[i] = plane == no_plane ? no_plane : number[plane];
  }
  assigned.moments = momentsOfLabels (
      points, assigned.labels, static_cast<std::size_t> (planes), threads);
  return assigned;
}

// The two sides of a wall that is thinner than a voxel are planes of their own.
LabelledPlanes
splitLayersOfVoxels (const Rounds& rounds,
                     const std::vector<Leaf>& leaves,
                     const Points& points,
                     LabelledPlanes found)
{
  // Steps of a quantized depth are some noises apart.
  constexpr double noises_apart = 10.0;
  constexpr double least_points = 1.0;
  const OpsParameters& parameters = rounds.parameters;
  std::vector<Plane> planes;
  for (const PlaneFit& fit : found.planes.fits)
    planes.push_back (fit.plane);
  Labels sorted = alongCurve (rounds.points, found.labels);
  std::vector<double> min_apart;
  for (const std::optional<double>& noise :
       expectedNoises (rounds.expected,
                       leaves,
                       planesOfLeaves (leaves, sorted),
                       planes.size(),
                       least_points))
    min_apart.push_back (std::max (noises_apart * noise.value_or (0.0),
                                   parameters.distance_threshold.value_or (0.0)));
  std::vector<char> is_kept (planes.size(), 1);
  if (!splitLayers (rounds.points, planes, min_apart, sorted, is_kept))
    return found;
  return relabelled (
      found,
      labelCloud (points, rounds.points, sorted, is_kept, parameters.threads),
      parameters.threads);
}

// The noise of the surroundings of each plane, as far as leaves that are not connected
// tell it.
LabelledPlanes
withNoisesOnVoxels (const Rounds& rounds,
                    const std::vector<Leaf>& leaves,
                    LabelledPlanes found)
{
  found.noises =
      expectedNoises (rounds.expected,
                      leaves,
                      planesOfLeaves (leaves, alongCurve (rounds.points, found.labels)),
                      found.planes.fits.size(),
                      points_that_tell * rounds.sizes.leaves.max_points);
  return found;
}

// The noise of the surroundings of each plane.
LabelledPlanes
withNoises (const Rounds& rounds, const LeafCloud& cloud, LabelledPlanes found)
{
  const Labels plane_of_leaf =
      planesOfLeaves (cloud.leaves, alongCurve (rounds.points, found.labels));
  found.noises = surroundingNoises (cloud,
                                    plane_of_leaf,
                                    found.planes.fits.size(),
                                    rounds.sizes.leaves.max_points,
                                    rounds.parameters.threads);
  return found;
}

// No plane is thicker than its noise says, but where a merging distance that a user
// gave makes one of several; and no point is farther away than theta_h from what the
// plane became.
LabelledPlanes
limitThickness (const Points& points,
                const OpsParameters& parameters,
                LabelledPlanes found)
{
  const bool is_merged =
      parameters.merging.enabled && parameters.merging.distance_threshold;
  ThinPlaneLimits limits;
  if (!is_merged)
    limits.noises = max_thickness_of_plane;
  if (!is_merged && parameters.distance_threshold)
    limits.distance = *parameters.distance_threshold;
  return keepThin (points, limits, parameters.threads, std::move (found));
}

JoiningParameters
joiningBy (const OpsParameters& parameters)
{
  constexpr double usual_noise_factor = 2.0;
  JoiningParameters joining;
  joining.max_distance = usual_noise_factor;
  joining.joins_over_gaps = parameters.merging.enabled;
  joining.max_angle_over_gaps = parameters.merging.angle_threshold;
  joining.max_distance_over_gaps =
      parameters.merging.noise_factor.value_or (usual_noise_factor);
  return joining;
}

// n_i: normals from the moments around.
std::vector<LeafSurfel>
orient (const Rounds& rounds, const LeafCloud& cloud, const LeafPlanes& planes)
{
  constexpr int rings = 4;
  return orientLeaves (cloud,
                       planes,
                       {rounds.sizes.min_points_of_normal, rings},
                       rounds.parameters.threads);
}

// Pi: finds planes among the leaves that have none, and lets all planes grow by a leaf.
void
spread (const Rounds& rounds,
        const LeafCloud& cloud,
        const std::vector<LeafSurfel>& surfels,
        double max_thickness,
        double leaves_per_inlier,
        LeafPlanes& planes)
{
  constexpr double max_distance = 2.5;
  const OpsParameters& parameters = rounds.parameters;
  spreadPlanes (
      cloud,
      surfels,
      {max_thickness,
       rounds.sizes.leaves_factor * leaves_per_inlier * parameters.min_samples,
       noises_of_a_leaf,
       parameters.surfels.angle_threshold},
      planes);
  measureNoise (cloud, parameters.threads, planes);
  growPlanes (cloud, max_distance, 1, parameters.threads, planes);
  refitPlanes (cloud, planes);
  measureNoise (cloud, parameters.threads, planes);
}

void
join (const Rounds& rounds, const LeafCloud& cloud, LeafPlanes& planes)
{
  joinPlanes (cloud, joiningBy (rounds.parameters), rounds.parameters.threads, planes);
}

// Gives leaves to likelier planes.
void
relax (const Rounds& rounds, const LeafCloud& cloud, LeafPlanes& planes)
{
  const unsigned threads = rounds.parameters.threads;
  const std::vector<char> relaxed = relaxLabels (cloud, threads, planes);
  measureNoise (cloud, threads, planes, &relaxed);
}

// Section III-C, by the noise of the planes instead of theta_h: lets planes grow to
// their borders, and makes one of those that are one.
void
finishPlanes (const Rounds& rounds, const LeafCloud& cloud, LeafPlanes& planes)
{
  constexpr double max_distance = 3.0;
  constexpr int max_rings = 50;
  const unsigned threads = rounds.parameters.threads;
  const std::vector<char> grown =
      growPlanes (cloud, max_distance, max_rings, threads, planes);
  refitPlanes (cloud, planes);
  measureNoise (cloud, threads, planes, &grown);
  join (rounds, cloud, planes);
  relax (rounds, cloud, planes);
}

// Together more may speak for planes than for either.
void
joinUnsure (const Rounds& rounds,
            const LeafCloud& cloud,
            const std::vector<LeafSurfel>& surfels,
            LeafPlanes& planes)
{
  const unsigned threads = rounds.parameters.threads;
  const std::vector<char> changed = joinByEvidence (cloud, surfels, threads, planes);
  if (std::find (changed.begin(), changed.end(), 1) == changed.end())
    return;
  measureNoise (cloud, threads, planes, &changed);
  relax (rounds, cloud, planes);
}

// Planes stay as thin as the noise of their surroundings asks for: hills are joined of
// pieces each of which is.
void
split (const Rounds& rounds, const LeafCloud& cloud, LeafPlanes& planes)
{
  const unsigned threads = rounds.parameters.threads;
  const std::vector<char> changed =
      splitThickPlanes (cloud, rounds.sizes.leaves.max_points, threads, planes);
  if (std::find (changed.begin(), changed.end(), 1) == changed.end())
    return;
  refitPlanes (cloud, planes);
  measureNoise (cloud, threads, planes, &changed);
  relax (rounds, cloud, planes);
}

// Every point of P, not of P_s alone, to a plane; planes for which enough speaks.
AssignedPoints
assign (const Rounds& rounds,
        const Points& points,
        const LeafCloud& cloud,
        const LeafPlanes& planes,
        const std::vector<LeafSurfel>& surfels)
{
  const OpsParameters& parameters = rounds.parameters;
  Labels labels = labelPoints (cloud,
                               planes,
                               noises_of_a_point,
                               parameters.distance_threshold,
                               parameters.threads);
  std::vector<char> is_kept =
      keptPlanes (cloud, planes, surfels, countLabels (labels, planes.planes.size()));
  splitLayers (cloud, planes, parameters.distance_threshold, labels, is_kept);
  return labelCloud (points, rounds.points, labels, is_kept, parameters.threads);
}

// Planes of a distance that a user gave are one, too.
LabelledPlanes
merge (AssignedPoints assigned, const OpsParameters& parameters)
{
  MergingParameters given = parameters.merging;
  given.enabled = given.enabled && given.distance_threshold.has_value();
  return mergeAssigned (std::move (assigned), given, parameters.threads);
}

// The median over the planes of how far a point may be from them, as the median of
// their leaves says.
std::optional<double>
usualDistance (const LeafPlanes& planes, const OpsParameters& parameters)
{
  if (parameters.distance_threshold)
    return parameters.distance_threshold;
  std::vector<std::vector<float>> noises (planes.planes.size());
  for (std::size_t i = 0; i < planes.plane_of_leaf.size(); ++i)
    if (planes.plane_of_leaf[i] != no_plane)
      noises[planes.plane_of_leaf[i]].push_back (static_cast<float> (planes.noise[i]));
  std::vector<float> of_planes;
  for (std::vector<float>& noise : noises)
    if (!noise.empty())
      of_planes.push_back (static_cast<float> (medianOf (noise)));
  if (of_planes.empty())
    return std::nullopt;
  return noises_of_a_point * medianOf (of_planes);
}

// The edge of the smallest leaves [m].
double
smallestEdge (const LeafCloud& cloud)
{
  return *std::min_element (cloud.edge.begin(), cloud.edge.end());
}

LeafPlanes
noPlanes (std::size_t leaves)
{
  return {{},
          Labels (leaves, no_plane),
          std::vector<double> (leaves, 0.0),
          std::vector<char> (leaves, 0)};
}

// Where no plane explains the points, leaves of half the edge.
void
divideAgain (const Rounds& rounds, LeafCloud& cloud, LeafPlanes& planes)
{
  HalvedLeaves halved = halveOpenLeaves (cloud, planes);
  cloud = measure (rounds, std::move (halved.leaves));
  planes = std::move (halved.planes);
}

} // namespace

LabelledPlanes
detectOnLeaves (const Points& points,
                const OpsParameters& parameters,
                StageDurations& times)
{
  // Leaves a plane needs: more while they are large, fewer in the last round.
  constexpr double first_leaves_per_inlier = 1.3;
  constexpr double last_leaves_per_inlier = 0.75;
  LabelledPlanes found;
  found.labels.assign (points.size(), no_plane);
  const OctreeSizes sizes = octreeSizes (points, parameters);
  if (points.size() == 0 || !(sizes.cell > 0.0))
    return found;
  const Rounds rounds =
      timed (times.search, [&] { return sortPoints (points, sizes, parameters); });
  std::vector<Leaf> leaves = timed (times.search, [&] { return divide (rounds); });
  if (parameters.sampling == Sampling::Automatic && prefersVoxels (rounds, leaves))
    return withNoisesOnVoxels (
        rounds,
        leaves,
        splitLayersOfVoxels (
            rounds, leaves, points, detectOnVoxels (points, parameters, times)));
  LeafCloud cloud =
      timed (times.search, [&] { return measure (rounds, std::move (leaves)); });
  const double used_edge = smallestEdge (cloud);
  LeafPlanes planes = noPlanes (cloud.size());
  const auto findPlanes = [&] (double max_thickness, double leaves_per_inlier) {
    std::vector<LeafSurfel> surfels =
        timed (times.normals, [&] { return orient (rounds, cloud, planes); });
    timed (times.extraction, [&] {
      spread (rounds, cloud, surfels, max_thickness, leaves_per_inlier, planes);
    });
    return surfels;
  };
  findPlanes (first_max_thickness, first_leaves_per_inlier);
  timed (times.merging, [&] { join (rounds, cloud, planes); });
  timed (times.search, [&] { divideAgain (rounds, cloud, planes); });
  const std::vector<LeafSurfel> surfels =
      findPlanes (last_max_thickness, last_leaves_per_inlier);
  // Those that were joined after the first round keep their places in the list.
  const std::size_t planes_before_merging = planes.planes.size();
  timed (times.merging, [&] {
    finishPlanes (rounds, cloud, planes);
    split (rounds, cloud, planes);
    joinUnsure (rounds, cloud, surfels, planes);
  });
  found = timed (times.assignment, [&] {
    found = merge (assign (rounds, points, cloud, planes, surfels), parameters);
    return limitThickness (
        points, parameters, withNoises (rounds, cloud, std::move (found)));
  });
  found.planes_before_merging = planes_before_merging;
  found.used = {used_edge, usualDistance (planes, parameters)};
  return found;
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/detect_on_voxels.h"

#include "geometry/noise_ratios.h"
#include "voxels/bounded_assignment.h"
#include "voxels/bounded_planes.h"
#include "voxels/plane_absorption.h"
#include "voxels/plane_extension.h"
#include "voxels/plane_growing.h"
#include "voxels/refinement.h"
#include "voxels/sparse_points.h"
#include "voxels/surfel_extraction.h"
#include "voxels/voxel_choice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pcl_ops::internal {

namespace {

using Parameters = OrientedPointSamplingParameters;

// Gives two limits for the number of points in a voxel and its neighbors, by the
// parameter k. A normal needs k / neighborhood_factor points at least: small CAD models
// often have fewer than k there. With fewer than k * neighborhood_factor points the
// voxel is sparse. Chosen by hand; src/doc/constants.csv has F with a factor of 1.
constexpr double neighborhood_factor = 2.0;

VoxelLevels
divideIntoVoxels (const Points& points, const Parameters& parameters)
{
  const std::optional<double> given = parameters.surfels.voxel_size;
  VoxelLevels voxels =
      given ? coarsen (voxelize (points, 0.5 * *given, parameters.threads))
            : voxelizeByNoise (points, parameters.sampling_rate, parameters.threads);
  connect (voxels.coarse, parameters.threads);
  return voxels;
}

std::vector<std::optional<Surfel>>
surfelsOf (const VoxelGrid& grid,
           const Parameters& parameters,
           const Labels& plane_of_voxel)
{
  const SurfelParameters& surfels = parameters.surfels;
  // An empty grid has the mean NaN; the other number is the maximum then.
  const double min_points =
      std::max (parameters.k / neighborhood_factor,
                surfels.min_average_voxels * meanPointsPerVoxel (grid));
  return findSurfels (
      grid, surfels.resolutions, min_points, parameters.threads, plane_of_voxel);
}

// Finds planes in voxels that have none, then grows all planes.
// \param[in] max_thickness as for extractSurfelPlanes
void
findPlanes (const VoxelGrid& grid,
            const Parameters& parameters,
            double max_thickness,
            BoundedPlanes& planes,
            StageDurations& durations)
{
  StageClock clock;
  const std::vector<std::optional<Surfel>> surfels =
      surfelsOf (grid, parameters, planes.plane_of_voxel);
  clock.lap (durations.normals);
  extractSurfelPlanes (grid, surfels, parameters, max_thickness, planes);
  measureNoise (grid, parameters.threads, planes);
  growPlanes (grid, parameters.distance_threshold, parameters.threads, planes);
  clock.lap (durations.extraction);
}

// By default planes are merged by their noise and not by a distance, as real walls are
// not flat.
MergingParameters
mergingByNoise (MergingParameters merging)
{
  merging.distance_threshold = merging.distance_threshold.value_or (0.0);
  merging.noise_factor = merging.noise_factor.value_or (like_noise_ratio);
  return merging;
}

// Merges parts of one plane: first those that touch, then also those beyond a gap.
MergedPlanes
mergedPlanes (const VoxelGrid& grid,
              const Parameters& parameters,
              const BoundedPlanes& planes)
{
  const Labels absorber_of =
      absorbPlanes (grid, parameters.surfels.absorption_noise_factor, planes);
  const std::vector<Moments> own_moments = momentsOfPlanes (grid, planes);
  // Of the absorbers with all that they absorb; absorbed planes have none.
  std::vector<Moments> moments (planes.size());
  for (std::size_t p = 0; p < planes.size(); ++p)
    moments[absorber_of[p]].addAligned (own_moments[p]);
  MergedPlanes merged = mergePlanes (moments, mergingByNoise (parameters.merging));
  const Labels merged_into_of_absorbers = merged.merged_into;
  for (std::size_t p = 0; p < planes.size(); ++p)
    merged.merged_into[p] = merged_into_of_absorbers[absorber_of[p]];
  return merged;
}

// Merges planes that are one, in the voxels of both sizes. planes has the planes found
// in coarse voxels. finer.planes has the same planes first, then those found in finer
// voxels; it has the finer voxels of all of them.
void
joinPlanes (const VoxelGrid& grid,
            const Parameters& parameters,
            BoundedPlanes& planes,
            Refinement& finer)
{
  const MergedPlanes merged = mergedPlanes (finer.grid, parameters, finer.planes);
  renumberPlanes (merged, planes);
  renumberPlanes (merged, finer.planes);
  measureNoise (grid, parameters.threads, planes);
  measureNoise (finer.grid, parameters.threads, finer.planes);
}

// Assigns the points of coarse voxels that are not refined, then those of finer voxels.
AssignedPoints
assign (const Points& points,
        const VoxelLevels& voxels,
        const BoundedPlanes& planes,
        const Refinement& finer,
        const Parameters& parameters)
{
  AssignedPoints assigned{Labels (points.size(), no_plane), {}};
  const auto assignIn = [&] (const VoxelGrid& grid,
                             const BoundedPlanes& planes_of_grid,
                             const std::vector<char>& is_left_out) {
    assignToBoundedPlanes (points,
                           grid,
                           planes_of_grid,
                           parameters.distance_threshold,
                           parameters.surfels.assignment_noise_factor,
                           parameters.threads,
                           is_left_out,
                           assigned);
  };
  assignIn (voxels.coarse, planes, finer.is_refined);
  assignIn (finer.grid, finer.planes, {});
  return assigned;
}

// What labelPoints reports about its result, besides the labels.
struct Tally {
  std::size_t planes_before_merging = 0;
  UsedLengths used;
};

// The (upper) median over all planes of the largest distance that their points may have
// [m]; nothing without planes.
std::optional<double>
usualDistanceLimit (const BoundedPlanes& planes,
                    const Refinement& finer,
                    const Parameters& parameters)
{
  std::vector<double> limits; // of each plane [m]
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const double noise =
        std::max ({planes.noise[p], finer.planes.noise[p], minNoise (finer.grid)});
    const double limit_by_noise = parameters.surfels.assignment_noise_factor * noise;
    limits.push_back (std::min (
        limit_by_noise, parameters.distance_threshold.value_or (limit_by_noise)));
  }
  if (limits.empty())
    return {};
  const auto middle = limits.begin() + static_cast<std::ptrdiff_t> (limits.size() / 2);
  std::nth_element (limits.begin(), middle, limits.end());
  return *middle;
}

// Defined below. It calls itself by way of detectAmong, each time for at most half of
// the points.
AssignedPoints
labelPoints (const Points& points,
             const Parameters& parameters,
             StageDurations& durations,
             Tally& tally);

// Finds planes among the points with these indices, in voxels of a size that suits
// them, and adds the planes to those in assigned.
void
detectAmong (const Points& points,
             const Indices& indices,
             const Parameters& parameters,
             StageDurations& durations,
             AssignedPoints& assigned)
{
  Points sparse;
  static_cast<Coordinates&> (sparse) = selected (points, indices);
  sparse.origin = points.origin;
  Tally tally_of_sparse;
  AssignedPoints found = labelPoints (sparse, parameters, durations, tally_of_sparse);
  rejectMist (assigned.moments, parameters.threads, found);
  const auto planes_before = static_cast<std::int32_t> (assigned.moments.size());
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (found.labels[i] != no_plane)
      assigned.labels[indices[i]] = planes_before + found.labels[i];
  assigned.moments.insert (
      assigned.moments.end(), found.moments.begin(), found.moments.end());
  // Merges planes again: a ground continues where its points become sparse.
  MergedPlanes merged =
      mergePlanes (assigned.moments, mergingByNoise (parameters.merging));
  relabel (assigned.labels, merged.merged_into, parameters.threads);
  assigned.moments = std::move (merged.moments);
}

// Labels the points that are too sparse for the voxels of the others.
void
labelSparsePoints (const Points& points,
                   const VoxelLevels& voxels,
                   const Parameters& parameters,
                   StageDurations& durations,
                   AssignedPoints& assigned)
{
  // A user who gives the size of voxels gets planes on these voxels alone, so that
  // parts of a cloud have the voxels of the whole.
  if (parameters.surfels.voxel_size)
    return;
  const VoxelGrid& grid = voxels.coarse;
  const Indices sparse = sparseVoxels (grid, neighborhood_factor * parameters.k);
  // Called again below, when detectAmong has labeled some of these points.
  const auto openSparsePoints = [&] {
    return openPoints (grid, sparse, assigned.labels);
  };
  const Indices indices = sparsePoints (openSparsePoints(), points.size());
  if (!indices.empty())
    detectAmong (points, indices, parameters, durations, assigned);
  extendPlanes (points,
                grid,
                openSparsePoints(),
                parameters.surfels.resolutions,
                parameters.distance_threshold,
                assigned);
}

// The stages of OPS on voxels, one after the other. P is the cloud; it, P_s, n_i, Pi,
// theta_h and section III-C are those of the paper (Sun & Mordohai 2019).
AssignedPoints
labelPoints (const Points& points,
             const Parameters& parameters,
             StageDurations& durations,
             Tally& tally)
{
  const SurfelParameters& surfels = parameters.surfels;
  StageClock clock;
  // The samples, P_s, are the voxels of a grid.
  const VoxelLevels voxels = divideIntoVoxels (points, parameters);
  const VoxelGrid& grid = voxels.coarse;
  if (grid.size() == 0)
    return {Labels (points.size(), no_plane), {}};
  tally.used.voxel_size = grid.voxel_size;
  BoundedPlanes planes;
  planes.plane_of_voxel.assign (grid.size(), no_plane);
  clock.lap (durations.search);
  // The normals, n_i, come from the moments of voxels and their neighbors. The planes,
  // Pi, grow over voxels.
  findPlanes (grid, parameters, surfels.sure_thickness, planes, durations);
  clock = StageClock(); // findPlanes has added its own time
  // Points that no plane explains are searched again, in voxels of half the edge.
  // finer.planes begins with the planes found so far; findPlanes appends new ones.
  Refinement finer = refine (voxels, planes, parameters.threads);
  clock.lap (durations.search);
  findPlanes (finer.grid, parameters, surfels.max_thickness, finer.planes, durations);
  clock = StageClock();
  tally.planes_before_merging = finer.planes.size();
  // Section III-C, by the noise of the planes instead of theta_h.
  joinPlanes (grid, parameters, planes, finer);
  tally.used.distance_threshold = usualDistanceLimit (planes, finer, parameters);
  clock.lap (durations.merging);
  // Each point of P gets a plane or none.
  AssignedPoints assigned = assign (points, voxels, planes, finer, parameters);
  clock.lap (durations.assignment);
  labelSparsePoints (points, voxels, parameters, durations, assigned);
  return assigned;
}

} // namespace

double
coarsestVoxel (const SurfelParameters& surfels)
{
  return std::ldexp (surfels.voxel_size.value_or (0.0), surfels.resolutions - 1);
}

LabeledPlanes
detectOnVoxels (const Points& points,
                const Parameters& parameters,
                StageDurations& durations)
{
  Tally tally;
  AssignedPoints assigned = labelPoints (points, parameters, durations, tally);
  // Only fits each plane to its points: planes have been merged already.
  MergingParameters keep_apart;
  keep_apart.enabled = false;
  LabeledPlanes found =
      mergePlanesOf (std::move (assigned), keep_apart, parameters.threads);
  found.planes_before_merging = tally.planes_before_merging;
  found.used = tally.used;
  return found;
}

} // namespace pcl_ops::internal

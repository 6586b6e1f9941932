// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/detect_on_voxels.h"

#include "bounded/bounded_assignment.h"
#include "bounded/noise_measurement.h"
#include "bounded/plane_absorption.h"
#include "bounded/plane_growing.h"
#include "bounded/refinement.h"
#include "ops/sparse_points.h"
#include "ops/surfel_extraction.h"
#include "ops/voxel_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

using Parameters = OrientedPointSamplingParameters;

VoxelPyramid
divide (const Points& points, const Parameters& parameters)
{
  const std::optional<double> given = parameters.surfels.voxel_size;
  return given ? voxelizeTwice (points, *given, parameters.threads)
               : voxelizeByNoise (points, parameters.sampling_rate, parameters.threads);
}

// All points, in the largest voxels.
Refinement
wholeOf (VoxelPyramid& voxels)
{
  Refinement whole;
  whole.grid = std::move (voxels.grids.back());
  whole.planes.plane_of_voxel.assign (whole.grid.size(), no_plane);
  return whole;
}

// n_i: of voxels that have no plane
std::vector<std::optional<Surfel>>
orient (const OpenVoxels& open, const VoxelGrid& grid, const Parameters& parameters)
{
  const double least_points =
      std::max (static_cast<double> (parameters.k),
                parameters.surfels.min_average_voxels * meanPointsPerVoxel (grid));
  return findSurfels (open.voxels, least_points, parameters.threads);
}

// Pi: planes that spread over like neighbors
BoundedPlanes
spread (const OpenVoxels& open,
        const std::vector<std::optional<Surfel>>& surfels,
        const Parameters& parameters,
        double max_thickness)
{
  SurfelExtractionParameters extraction;
  extraction.noise_factor = parameters.surfels.noise_factor;
  extraction.angle_threshold = parameters.surfels.angle_threshold;
  extraction.max_thickness = max_thickness;
  extraction.min_inliers = std::max (1u, parameters.min_inliers);
  return extractSurfelPlanes (open.voxels.grids[0], surfels, extraction);
}

// Finds planes in voxels that have none, and lets all planes grow.
void
findPlanes (const Parameters& parameters,
            double max_thickness,
            StageDurations& durations,
            Refinement& part)
{
  StageClock clock;
  OpenVoxels open =
      openVoxels (part, parameters.surfels.resolutions, parameters.threads);
  const std::vector<std::optional<Surfel>> surfels =
      orient (open, part.grid, parameters);
  clock.lap (durations.normals);
  addPlanes (
      open.numbers, spread (open, surfels, parameters, max_thickness), part.planes);
  if (part.grid.neighbours.size() == 0) // of the whole, which was all open
    part.grid.neighbours = std::move (open.voxels.grids[0].neighbours);
  measureNoise (part.grid, parameters.threads, part.planes);
  growPlanes (
      part.grid, parameters.distance_threshold, parameters.threads, part.planes);
  clock.lap (durations.extraction);
}

// Which planes are one: those that noise divided, and those that a gap did.
MergedPlanes
mergedPlanes (const VoxelGrid& grid,
              const Parameters& parameters,
              const BoundedPlanes& planes)
{
  const Labels absorbed =
      absorbPlanes (grid, parameters.surfels.absorption_noise_factor, planes);
  const std::vector<Moments> parts = momentsOfPlanes (grid, planes);
  std::vector<Moments> moments (parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p)
    moments[static_cast<std::size_t> (absorbed[p])].addAligned (parts[p]);
  MergedPlanes merged = mergePlanes (moments, mergingByNoise (parameters.merging));
  const Labels of_absorbers = merged.merged_into;
  for (std::size_t p = 0; p < parts.size(); ++p)
    merged.merged_into[p] = of_absorbers[static_cast<std::size_t> (absorbed[p])];
  return merged;
}

// Makes one plane of those that are one, in voxels of all sizes.
void
joinPlanes (const Parameters& parameters, std::vector<Refinement>& parts)
{
  const MergedPlanes merged =
      mergedPlanes (parts.back().grid, parameters, parts.back().planes);
  for (Refinement& part : parts) {
    renumberPlanes (merged, part.planes);
    measureNoise (part.grid, parameters.threads, part.planes);
  }
}

// The points of voxels that are not refined.
AssignedPoints
assign (const Points& points,
        const Indices& order,
        const std::vector<Refinement>& parts,
        const Parameters& parameters)
{
  AssignedPoints assigned{Labels (points.size(), no_plane), {}};
  for (const Refinement& part : parts)
    assignToBoundedPlanes (points,
                           order,
                           part.grid,
                           part.planes,
                           parameters.distance_threshold,
                           parameters.surfels.assignment_noise_factor,
                           parameters.threads,
                           part.is_refined,
                           assigned);
  return assigned;
}

AssignedPoints
labelPoints (const Points& points,
             const Parameters& parameters,
             StageDurations& durations,
             std::size_t& found);

// Looks for planes among points too sparse for the voxels of the others.
void
labelSparsePoints (const Points& points,
                   const Indices& order,
                   const VoxelGrid& grid,
                   const Parameters& parameters,
                   StageDurations& durations,
                   AssignedPoints& assigned)
{
  // Voxels of a given size do not change with the points.
  if (parameters.surfels.voxel_size)
    return;
  const Indices numbers = sparsePoints (grid, order, assigned.labels, parameters.k);
  if (numbers.empty())
    return;
  Points sparse;
  static_cast<Coordinates&> (sparse) = selected (points, numbers);
  sparse.origin = points.origin;
  std::size_t found = 0;
  const AssignedPoints more = labelPoints (sparse, parameters, durations, found);
  const auto before = static_cast<std::int32_t> (assigned.moments.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (more.labels[i] != no_plane)
      assigned.labels[numbers[i]] = before + more.labels[i];
  assigned.moments.insert (
      assigned.moments.end(), more.moments.begin(), more.moments.end());
  // A ground goes on where it becomes sparse.
  MergedPlanes merged =
      mergePlanes (assigned.moments, mergingByNoise (parameters.merging));
  relabel (assigned.labels, merged.merged_into, parameters.threads);
  assigned.moments = std::move (merged.moments);
}

// The straight line of OPS on voxels. found: planes before they are joined.
AssignedPoints
labelPoints (const Points& points,
             const Parameters& parameters,
             StageDurations& durations,
             std::size_t& found)
{
  StageClock clock;
  // P_s: the voxels of a grid, and those of half the edge
  VoxelPyramid voxels = divide (points, parameters);
  clock.lap (durations.search);
  if (voxels.grids.empty())
    return {Labels (points.size(), no_plane), {}};
  // n_i and Pi: planes of large voxels, and of what they leave in voxels of half the
  // edge
  std::vector<Refinement> parts;
  parts.push_back (wholeOf (voxels));
  findPlanes (parameters, parameters.surfels.sure_thickness, durations, parts[0]);
  clock = StageClock();
  parts.push_back (
      refine (voxels.grids[0], voxels.voxels_above[0], parameters.threads, parts[0]));
  clock.lap (durations.search);
  findPlanes (parameters, parameters.surfels.max_thickness, durations, parts[1]);
  clock = StageClock();
  found = parts.back().planes.size();
  // section III-C, by the noise of the planes instead of theta_h
  joinPlanes (parameters, parts);
  clock.lap (durations.merging);
  // every point of P, not of P_s alone, to a plane
  AssignedPoints assigned = assign (points, voxels.order, parts, parameters);
  clock.lap (durations.assignment);
  labelSparsePoints (
      points, voxels.order, parts.front().grid, parameters, durations, assigned);
  return assigned;
}

} // namespace

double
coarsestVoxel (const SurfelParameters& surfels)
{
  return std::ldexp (surfels.voxel_size.value_or (0.0), surfels.resolutions - 1);
}

MergingParameters
mergingByNoise (MergingParameters merging)
{
  constexpr double usual_noise_factor = 1.5;
  merging.distance_threshold = merging.distance_threshold.value_or (0.0);
  merging.noise_factor = merging.noise_factor.value_or (usual_noise_factor);
  return merging;
}

LabelledPlanes
detectOnVoxels (const Points& points,
                const Parameters& parameters,
                StageDurations& durations)
{
  std::size_t found_planes = 0;
  AssignedPoints assigned = labelPoints (points, parameters, durations, found_planes);
  // Planes are fitted to their points; which are one has been settled.
  MergingParameters keep_apart;
  keep_apart.enabled = false;
  LabelledPlanes found =
      mergeAssigned (std::move (assigned), keep_apart, parameters.threads);
  found.planes_before_merging = found_planes;
  return found;
}

} // namespace pcl_ops::internal

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/voxel_surfels.h"

#include "bounded/bounded_assignment.h"
#include "bounded/hole_filling.h"
#include "bounded/noise_measurement.h"
#include "bounded/plane_absorption.h"
#include "bounded/plane_growing.h"
#include "ops/sparse_points.h"
#include "ops/surfel_extraction.h"
#include "ops/voxel_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

using Surfels = std::vector<std::optional<Surfel>>;

Surfels
surfelsOf (const VoxelGrid& grid,
           const OrientedPointSamplingParameters& parameters,
           const Labels& plane_of_voxel = {})
{
  const SurfelParameters& surfels = parameters.surfels;
  const double least_points =
      std::max (static_cast<double> (parameters.k),
                surfels.least_average_voxels * meanPointsPerVoxel (grid));
  return findSurfels (
      grid, surfels.resolutions, least_points, parameters.threads, plane_of_voxel);
}

SurfelExtractionParameters
extractionParameters (const OrientedPointSamplingParameters& parameters,
                      double largest_thickness)
{
  SurfelExtractionParameters extraction;
  extraction.noise_factor = parameters.surfels.noise_factor;
  extraction.angle_threshold = parameters.surfels.angle_threshold;
  extraction.largest_thickness = largest_thickness;
  extraction.min_inliers = std::max (1u, parameters.min_inliers);
  return extraction;
}

// Makes one plane of those that noise tore apart, and of those that a gap did.
void
joinPlanes (const VoxelGrid& grid,
            const OrientedPointSamplingParameters& parameters,
            BoundedPlanes& planes)
{
  absorbPlanes (grid, parameters.surfels.absorption_noise_factor, planes);
  renumberPlanes (
      mergePlanes (momentsOfPlanes (grid, planes), mergingByNoise (parameters.merging)),
      planes);
}

} // namespace

MergingParameters
mergingByNoise (MergingParameters merging)
{
  constexpr double usual_noise_factor = 1.5;
  merging.distance_threshold = merging.distance_threshold.value_or (0.0);
  merging.noise_factor = merging.noise_factor.value_or (usual_noise_factor);
  return merging;
}

double
coarsestVoxel (const SurfelParameters& surfels)
{
  return std::ldexp (surfels.voxel_size.value_or (0.0), surfels.resolutions - 1);
}

VoxelizedPoints
VoxelSurfels::sample (const Points& points) const
{
  const std::optional<double> given = parameters_.surfels.voxel_size;
  return given
             ? voxelize (points, *given, parameters_.threads)
             : voxelizeByNoise (points, parameters_.sampling_rate, parameters_.threads);
}

std::vector<std::optional<Surfel>>
VoxelSurfels::orient (const Points& /*points*/, const VoxelizedPoints& voxelized) const
{
  return surfelsOf (voxelized.grid, parameters_);
}

RefinedPlanes
VoxelSurfels::extract (const Points& points,
                       const VoxelizedPoints& voxelized,
                       const std::vector<std::optional<Surfel>>& surfels) const
{
  const unsigned threads = parameters_.threads;
  RefinedPlanes planes;
  const auto extract_among =
      [&] (const VoxelGrid& grid, const Surfels& own, double thickness, auto& among) {
        const std::size_t before = among.size();
        extractSurfelPlanes (
            grid, own, extractionParameters (parameters_, thickness), among);
        planes.found += among.size() - before;
        fillHoles (grid, threads, among);
      };
  const VoxelGrid& grid = voxelized.grid;
  planes.coarse.plane_of_voxel.assign (grid.size(), no_plane);
  planes.coarse.noise.assign (grid.size(), 0.0);
  extract_among (grid, surfels, parameters_.surfels.sure_thickness, planes.coarse);
  measureNoise (grid, threads, planes.coarse);
  joinPlanes (grid, parameters_, planes.coarse);
  measureNoise (grid, threads, planes.coarse);
  planes.finer = refine (points, voxelized, planes.coarse, threads);
  const VoxelGrid& finer = planes.finer.voxelized.grid;
  extract_among (finer,
                 surfelsOf (finer, parameters_, planes.finer.planes.plane_of_voxel),
                 parameters_.surfels.largest_thickness,
                 planes.finer.planes);
  return planes;
}

void
VoxelSurfels::bound (const Points& /*points*/,
                     const VoxelizedPoints& /*voxelized*/,
                     RefinedPlanes& planes) const
{
  const VoxelGrid& grid = planes.finer.voxelized.grid;
  BoundedPlanes& bounded = planes.finer.planes;
  growPlanes (grid, parameters_.distance_threshold, parameters_.threads, bounded);
  joinPlanes (grid, parameters_, bounded);
  reassignVoxels (grid, parameters_.threads, bounded);
  measureNoise (grid, parameters_.threads, bounded);
  relabel (planes.coarse.plane_of_voxel, bounded.became, parameters_.threads);
  planes.coarse.planes = bounded.planes;
}

AssignedPoints
VoxelSurfels::assign (const Points& points,
                      const VoxelizedPoints& voxelized,
                      const RefinedPlanes& planes) const
{
  if (voxelized.grid.size() == 0)
    return {Labels (points.size(), no_plane), {}};
  AssignedPoints assigned = assignInVoxels (points, voxelized, planes);
  addSparse (points, voxelized, assigned);
  return assigned;
}

void
VoxelSurfels::addSparse (const Points& points,
                         const VoxelizedPoints& voxelized,
                         AssignedPoints& assigned) const
{
  // Voxels of a given size do not change with the points.
  if (parameters_.surfels.voxel_size)
    return;
  const Indices numbers = sparsePoints (voxelized, assigned.labels, parameters_.k);
  if (numbers.empty())
    return;
  Points sparse;
  static_cast<Coordinates&> (sparse) = selected (points, numbers);
  sparse.origin = points.origin;
  const VoxelizedPoints voxels = sample (sparse);
  RefinedPlanes planes = extract (sparse, voxels, orient (sparse, voxels));
  bound (sparse, voxels, planes);
  const AssignedPoints more = assign (sparse, voxels, planes);
  const auto before = static_cast<std::int32_t> (assigned.moments.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (more.labels[i] != no_plane)
      assigned.labels[numbers[i]] = before + more.labels[i];
  assigned.moments.insert (
      assigned.moments.end(), more.moments.begin(), more.moments.end());
  // A ground goes on where it becomes sparse.
  MergedPlanes merged =
      mergePlanes (assigned.moments, mergingByNoise (parameters_.merging));
  relabel (assigned.labels, merged.merged_into, parameters_.threads);
  assigned.moments = std::move (merged.moments);
}

AssignedPoints
VoxelSurfels::assignInVoxels (const Points& points,
                              const VoxelizedPoints& voxelized,
                              const RefinedPlanes& planes) const
{
  const auto assigned = [&] (const Coordinates& positions,
                             const VoxelizedPoints& voxels,
                             const BoundedPlanes& bounded,
                             const std::vector<char>& is_left_out) {
    return assignToBoundedPlanes (positions,
                                  voxels,
                                  bounded,
                                  parameters_.distance_threshold,
                                  parameters_.surfels.assignment_noise_factor,
                                  parameters_.threads,
                                  is_left_out);
  };
  const Refinement& finer = planes.finer;
  AssignedPoints all = assigned (points, voxelized, planes.coarse, finer.is_refined);
  const AssignedPoints refined =
      assigned (finer.positions, finer.voxelized, finer.planes, {});
  for (std::size_t i = 0; i < finer.points.size(); ++i)
    all.labels[finer.points[i]] = refined.labels[i];
  for (std::size_t p = 0; p < all.moments.size(); ++p)
    all.moments[p].addAligned (refined.moments[p]);
  return all;
}

LabelledPlanes
VoxelSurfels::merge (AssignedPoints assigned) const
{
  MergingParameters keep_apart;
  keep_apart.enabled = false;
  return mergeAssigned (std::move (assigned), keep_apart, parameters_.threads);
}

} // namespace pcl_ops::internal

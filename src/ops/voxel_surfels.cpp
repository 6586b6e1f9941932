// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/voxel_surfels.h"

#include "bounded/bounded_assignment.h"
#include "bounded/noise_floors.h"
#include "bounded/plane_absorption.h"
#include "bounded/plane_growing.h"
#include "bounded/surface_separation.h"
#include "ops/surfel_extraction.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

// How many voxels to divide a cloud into. Measured on rooms of 50 k to 3 M points:
// smaller planes need more voxels, but noise does not shrink with their size, so that
// their number grows much more slowly than that of the points.
double
wantedVoxels (std::size_t points, double sampling_rate)
{
  constexpr double voxels_per_sample = 4.0 / 3.0;
  constexpr double reference_points = 300000.0;
  constexpr double fewest_points_per_voxel = 5.0;
  const auto number = static_cast<double> (points);
  const double samples =
      sampling_rate * reference_points * std::cbrt (number / reference_points);
  return std::min (voxels_per_sample * samples, number / fewest_points_per_voxel);
}

double
meanPointsPerVoxel (const VoxelGrid& grid)
{
  double points = 0.0;
  for (const Moments& voxel : grid.moments)
    points += voxel.count;
  return points / static_cast<double> (grid.size());
}

SurfelRansacParameters
ransacParameters (const VoxelGrid& grid,
                  const OrientedPointSamplingParameters& parameters)
{
  const SurfelParameters& surfels = parameters.surfels;
  SurfelRansacParameters ransac;
  ransac.distance_limit = distanceLimit (grid, parameters.distance_threshold);
  ransac.noise_factor = surfels.noise_factor;
  ransac.angle_threshold = surfels.angle_threshold;
  ransac.largest_normal_spread = surfels.largest_normal_spread;
  ransac.largest_thickness = surfels.largest_thickness;
  ransac.min_inliers = std::max (1u, parameters.min_inliers);
  ransac.probability = parameters.probability;
  return ransac;
}

// Real walls are not flat: whether two planes are one follows their noise.
MergingParameters
mergingByNoise (MergingParameters merging)
{
  constexpr double usual_noise_factor = 2.25;
  merging.distance_threshold = merging.distance_threshold.value_or (0.0);
  merging.noise_factor = merging.noise_factor.value_or (usual_noise_factor);
  return merging;
}

} // namespace

VoxelizedPoints
VoxelSurfels::sample (const Points& points) const
{
  const std::optional<double> given = parameters_.surfels.voxel_size;
  const double voxel_size =
      given ? *given
            : voxelSizeFor (points,
                            wantedVoxels (points.size(), parameters_.sampling_rate));
  if (!(voxel_size > 0.0))
    return {};
  return voxelize (points, voxel_size, parameters_.threads);
}

std::vector<std::optional<Surfel>>
VoxelSurfels::orient (const Points& /*points*/, const VoxelizedPoints& voxelized) const
{
  const SurfelParameters& surfels = parameters_.surfels;
  const VoxelGrid& grid = voxelized.grid;
  const double least_points =
      std::max (static_cast<double> (parameters_.k),
                surfels.least_average_voxels * meanPointsPerVoxel (grid));
  return findSurfels (grid, surfels.resolutions, least_points, parameters_.threads);
}

BoundedPlanes
VoxelSurfels::extract (const Points& /*points*/,
                       const VoxelizedPoints& voxelized,
                       const std::vector<std::optional<Surfel>>& surfels) const
{
  const VoxelGrid& grid = voxelized.grid;
  RandomGenerator generator (parameters_.seed);
  BoundedPlanes planes;
  SurfelRansacParameters ransac = ransacParameters (grid, parameters_);
  for (const double thickness :
       {parameters_.surfels.sure_thickness, parameters_.surfels.largest_thickness}) {
    ransac.largest_thickness = thickness;
    extractSurfelPlanes (grid, surfels, ransac, generator, planes);
    growPlanes (grid,
                parameters_.distance_threshold,
                parameters_.surfels.growing_rounds,
                parameters_.threads,
                planes);
  }
  return planes;
}

void
VoxelSurfels::bound (const Points& points,
                     const VoxelizedPoints& voxelized,
                     BoundedPlanes& planes) const
{
  const VoxelGrid& grid = voxelized.grid;
  absorbPlanes (grid, parameters_.surfels.absorption_noise_factor, planes);
  renumberPlanes (mergePlanes (momentsOfPlanes (grid, planes),
                               mergingByNoise (parameters_.merging)),
                  planes);
  reassignVoxels (grid, parameters_.threads, planes);
  if (parameters_.surfels.separates_surfaces)
    separateSurfaces (
        grid, input_.viewpoint - points.origin, parameters_.min_inliers, planes);
  measureNoise (grid, parameters_.threads, planes);
}

AssignedPoints
VoxelSurfels::assign (const Points& points,
                      const VoxelizedPoints& voxelized,
                      const BoundedPlanes& planes) const
{
  if (voxelized.grid.size() == 0)
    return {Labels (points.size(), no_plane), {}};
  return assignToBoundedPlanes (points,
                                voxelized,
                                planes,
                                parameters_.distance_threshold,
                                parameters_.surfels.assignment_noise_factor,
                                parameters_.threads);
}

LabelledPlanes
VoxelSurfels::merge (AssignedPoints assigned) const
{
  MergingParameters keep_apart;
  keep_apart.enabled = false;
  return mergeAssigned (std::move (assigned), keep_apart, parameters_.threads);
}

} // namespace pcl_ops::internal

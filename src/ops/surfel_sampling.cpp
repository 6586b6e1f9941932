// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/stage_timer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops {

namespace {

// How many cells to divide a cloud into. Measured on rooms of 50 k to 3 M points:
// smaller planes need more cells, but noise does not shrink with their size, so that
// their number grows much more slowly than that of the points.
double
wantedCells (std::size_t points, double sampling_rate)
{
  constexpr double cells_per_sample = 4.0 / 3.0;
  constexpr double reference_points = 300000.0;
  constexpr double fewest_points_per_cell = 5.0;
  const auto number = static_cast<double> (points);
  const double samples =
      sampling_rate * reference_points * std::cbrt (number / reference_points);
  return std::min (cells_per_sample * samples, number / fewest_points_per_cell);
}

double
cellSize (const Coordinates& positions,
          const OrientedPointSamplingParameters& parameters)
{
  return parameters.cells.size > 0.0
             ? parameters.cells.size
             : cellSizeFor (positions,
                            wantedCells (positions.size(), parameters.sampling_rate));
}

CellRansacParameters
cellRansacParameters (const OrientedPointSamplingParameters& parameters)
{
  CellRansacParameters ransac;
  ransac.inlier = parameters.cells.inlier;
  ransac.inlier.distance_threshold = parameters.distance_threshold;
  ransac.min_inliers = std::max (1u, parameters.min_inliers);
  ransac.probability = parameters.probability;
  return ransac;
}

CellNormalParameters
normalParameters (const OrientedPointSamplingParameters& parameters)
{
  CellNormalParameters normals = parameters.cells.normals;
  normals.least_points = parameters.normals.k;
  return normals;
}

GrowingParameters
growingParameters (const OrientedPointSamplingParameters& parameters)
{
  GrowingParameters growing = parameters.cells.growing;
  growing.distance_threshold = parameters.distance_threshold;
  return growing;
}

BoundedAssignmentParameters
assignmentParameters (const OrientedPointSamplingParameters& parameters)
{
  BoundedAssignmentParameters assignment = parameters.cells.assignment;
  assignment.distance_threshold = parameters.distance_threshold;
  return assignment;
}

// Planes of sure cells first, then of all that are left.
CellPlanes
findPlanes (const CellGrid& grid,
            const std::vector<std::optional<CellNormal>>& normals,
            const OrientedPointSamplingParameters& parameters)
{
  RandomGenerator generator (parameters.seed);
  CellRansacParameters ransac = cellRansacParameters (parameters);
  CellPlanes planes;
  for (const double thickness :
       {parameters.cells.sure_thickness, parameters.cells.inlier.largest_thickness}) {
    ransac.inlier.largest_thickness = thickness;
    extractCellPlanes (grid, normals, ransac, generator, planes);
    growPlanes (grid, growingParameters (parameters), parameters.threads, planes);
  }
  return planes;
}

// Which cells are whose in the end, and how much noise there is.
void
settlePlanes (const CellGrid& grid,
              const Eigen::Vector3d& viewpoint,
              const OrientedPointSamplingParameters& parameters,
              CellPlanes& planes)
{
  absorbPlanes (grid, parameters.cells.absorption_noise_factor, planes);
  renumberPlanes (mergePlanes (momentsOfPlanes (grid, planes), parameters.merging),
                  planes);
  reassignCells (grid, parameters.threads, planes);
  if (parameters.cells.separates_surfaces)
    separateSurfaces (grid, viewpoint, parameters.min_inliers, planes);
  measureNoise (grid, parameters.threads, planes);
}

} // namespace

Detection
detectOnCells (Points points,
               const Eigen::Vector3d& viewpoint,
               const OrientedPointSamplingParameters& parameters,
               StageDurations& durations)
{
  Detection found;
  found.points = std::move (points);
  const double cell_size = cellSize (found.points, parameters);
  if (!(cell_size > 0.0)) {
    found.labels.assign (found.points.size(), no_plane);
    return found;
  }
  const GriddedPoints gridded = timed (durations.search, [&] {
    return gridPoints (found.points, cell_size, parameters.threads);
  });
  const CellGrid& grid = gridded.grid;
  const auto normals = timed (durations.normals, [&] {
    return orientCells (grid, normalParameters (parameters), parameters.threads);
  });
  CellPlanes planes = timed (durations.extraction,
                             [&] { return findPlanes (grid, normals, parameters); });
  timed (durations.merging, [&] {
    settlePlanes (grid, viewpoint - found.points.origin, parameters, planes);
    return 0;
  });
  AssignedPoints assigned = timed (durations.assignment, [&] {
    return assignToBoundedPlanes (found.points,
                                  gridded,
                                  planes,
                                  assignmentParameters (parameters),
                                  parameters.threads);
  });
  found.labels = std::move (assigned.labels);
  found.planes = timed (durations.merging, [&] {
    MergingParameters keep_apart;
    keep_apart.enabled = false;
    return mergePlanes (assigned.moments, keep_apart);
  });
  relabel (found.labels, found.planes.merged_into, parameters.threads);
  return found;
}

} // namespace pcl_ops

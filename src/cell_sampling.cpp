// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/stage_timer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops {

namespace {

// At the recommended alpha_s = 3 % a cloud of 300,000 points gets 9,000 cells; the
// number grows with the square root of the points, as more points show finer detail but
// are spent on less noisy cells, too.
double
wantedCells (const Points& points, double sampling_rate)
{
  constexpr double reference_points = 300000.0;
  return sampling_rate *
         std::sqrt (reference_points * static_cast<double> (points.size()));
}

CellRansacParameters
cellRansacParameters (const OrientedPointSamplingParameters& parameters)
{
  CellRansacParameters ransac;
  ransac.inlier = parameters.cells.inlier;
  ransac.min_inliers = std::max (1u, parameters.min_inliers);
  ransac.probability = parameters.probability;
  return ransac;
}

} // namespace

Detection
detectOnCells (Points points,
               const OrientedPointSamplingParameters& parameters,
               StageDurations& durations)
{
  Detection found;
  found.points = std::move (points);
  found.labels.assign (found.points.size(), no_plane);
  const double cell_size =
      parameters.cells.size > 0.0
          ? parameters.cells.size
          : cellSizeFor (found.points,
                         wantedCells (found.points, parameters.sampling_rate));
  if (!(cell_size > 0.0))
    return found;
  const GriddedPoints gridded = timed (durations.search, [&] {
    return gridPoints (found.points, cell_size, parameters.threads);
  });
  const CellGrid& grid = gridded.grid;
  const auto normals = timed (durations.normals, [&] {
    return orientCells (grid, parameters.cells.normals, parameters.threads);
  });
  RandomGenerator generator (parameters.seed);
  CellPlanes planes = timed (durations.extraction, [&] {
    return extractCellPlanes (
        grid, normals, cellRansacParameters (parameters), generator);
  });
  timed (durations.merging, [&] {
    growPlanes (grid, parameters.cells.growing, planes);
    absorbPlanes (grid, parameters.cells.absorption_noise_factor, planes);
    const MergedPlanes merged =
        mergePlanes (momentsOfPlanes (grid, planes), parameters.merging);
    renumberPlanes (grid, merged.merged_into, merged.fits.size(), planes);
    reassignCells (grid, planes);
    return 0;
  });
  AssignedPoints assigned = timed (durations.assignment, [&] {
    return assignToBoundedPlanes (
        found.points, gridded, planes, parameters.cells.assignment, parameters.threads);
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

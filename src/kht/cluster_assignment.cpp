// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_units.h"
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/stage_timer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops {
namespace {

// Into how many cells a cloud is divided to follow its planes' outlines.
constexpr double wanted_cells = 9000.0;

std::vector<Plane>
withoutClusters (const std::vector<HoughPlane>& hough_planes)
{
  std::vector<Plane> planes;
  planes.reserve (hough_planes.size());
  for (const HoughPlane& plane : hough_planes)
    planes.push_back (plane.plane);
  return planes;
}

/** Blocks of the octree lie together, so that most planes are far from most blocks. */
Labels
assignOctreePoints (const OctreeClusters& found,
                    std::size_t size,
                    const std::vector<Plane>& planes,
                    const KernelHoughTransformParameters& parameters)
{
  const Labels in_octree_order = assignPoints (found.points,
                                               planes,
                                               parameters.distance_threshold,
                                               parameters.assignment,
                                               parameters.threads);
  Labels labels (size, no_plane);
  for (std::size_t i = 0; i < in_octree_order.size(); ++i)
    labels[found.points.order[i]] = in_octree_order[i];
  return labels;
}

/** Each cell goes to the plane of the first cluster that has a point in it. */
CellPlanes
cellsOfClusters (const std::vector<HoughPlane>& planes,
                 const OctreeClusters& found,
                 const GriddedPoints& gridded)
{
  CellPlanes cells;
  cells.plane_of_cell.assign (gridded.grid.size(), no_plane);
  cells.noise.assign (gridded.grid.size(), 0.0);
  for (const HoughPlane& plane : planes) {
    const auto label = static_cast<std::int32_t> (cells.planes.size());
    cells.planes.push_back (plane.plane);
    for (const std::uint32_t c : plane.clusters) {
      const CoplanarCluster& cluster = found.clusters[c];
      const double noise =
          std::sqrt (meanSquaredDistance (cluster.moments, plane.plane));
      for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
        const std::uint32_t cell = gridded.cell_of_point[found.points.order[i]];
        if (cells.plane_of_cell[cell] != no_plane)
          continue;
        cells.plane_of_cell[cell] = label;
        cells.noise[cell] = std::max (noise, smallestNoise (gridded.grid));
      }
    }
  }
  return cells;
}

/** Grows, merges and refits planes on their cells.
 * \return for each plane the one it went into, or no_plane */
Labels
settleCells (const CellGrid& grid,
             const KernelHoughTransformParameters& parameters,
             CellPlanes& cells)
{
  GrowingParameters growing;
  growing.distance_threshold = parameters.distance_threshold;
  growPlanes (grid, growing, parameters.threads, cells);
  const MergedPlanes merged =
      mergePlanes (momentsOfPlanes (grid, cells), parameters.merging);
  renumberPlanes (merged, cells);
  reassignCells (grid, parameters.threads, cells);
  return merged.merged_into;
}

} // namespace

Detection
assignToEndlessPlanes (Points points,
                       const OctreeClusters& found,
                       const std::vector<HoughPlane>& hough_planes,
                       const KernelHoughTransformParameters& parameters,
                       StageDurations& durations)
{
  const std::vector<Plane> planes = withoutClusters (hough_planes);
  Detection detection;
  detection.points = std::move (points);
  detection.labels = timed (durations.assignment, [&] {
    return assignOctreePoints (found, detection.points.size(), planes, parameters);
  });
  detection.planes = timed (durations.merging, [&] {
    return mergeLabelled (detection.points,
                          detection.labels,
                          planes.size(),
                          parameters.merging,
                          parameters.threads);
  });
  if (!parameters.refit.enabled)
    restorePlanes (detection.planes, planes);
  return detection;
}

Detection
assignToOutlinedPlanes (Points points,
                        const OctreeClusters& found,
                        const std::vector<HoughPlane>& planes,
                        const KernelHoughTransformParameters& parameters,
                        StageDurations& durations)
{
  Detection detection;
  detection.points = std::move (points);
  detection.labels.assign (detection.points.size(), no_plane);
  if (planes.empty())
    return detection;
  const GriddedPoints gridded = timed (durations.search, [&] {
    const double cell_size = cellSizeFor (detection.points, wanted_cells);
    return gridPoints (detection.points, cell_size, parameters.threads);
  });
  CellPlanes cells = cellsOfClusters (planes, found, gridded);
  Labels merged_into = timed (
      durations.merging, [&] { return settleCells (gridded.grid, parameters, cells); });
  AssignedPoints assigned = timed (durations.assignment, [&] {
    BoundedAssignmentParameters bounded;
    bounded.distance_threshold = parameters.distance_threshold;
    return assignToBoundedPlanes (
        detection.points, gridded, cells, bounded, parameters.threads);
  });
  MergingParameters keep_apart;
  keep_apart.enabled = false;
  detection.planes = mergePlanes (assigned.moments, keep_apart);
  detection.labels = std::move (assigned.labels);
  relabel (detection.labels, detection.planes.merged_into, parameters.threads);
  relabel (merged_into, detection.planes.merged_into, parameters.threads);
  detection.planes.merged_into = std::move (merged_into);
  return detection;
}

} // namespace pcl_ops

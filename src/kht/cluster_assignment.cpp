// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kht/cluster_assignment.h"

#include "base/stage_clock.h"
#include "bounded/bounded_assignment.h"
#include "bounded/noise_measurement.h"
#include "bounded/plane_growing.h"
#include "voxels/voxel_size.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {
namespace {

// Into how many voxels a cloud is divided to follow its planes' outlines.
constexpr double wanted_voxels = 9000.0;

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
  Coordinates points;
  for (const OctreePoint& point : found.points)
    points.add (point.x, point.y, point.z);
  const Labels in_octree_order = assignPoints (points,
                                               planes,
                                               *parameters.distance_threshold,
                                               AssignmentRule::First,
                                               parameters.threads);
  Labels labels (size, no_plane);
  for (std::size_t i = 0; i < in_octree_order.size(); ++i)
    labels[found.points[i].index] = in_octree_order[i];
  return labels;
}

/** Each voxel goes to the plane of the first cluster that has a point in it. */
BoundedPlanes
voxelsOfClusters (const std::vector<HoughPlane>& planes,
                  const OctreeClusters& found,
                  const VoxelizedPoints& voxelized)
{
  const Indices voxel_of_point = voxelsOfPoints (voxelized.grid, voxelized.order);
  BoundedPlanes voxels;
  voxels.plane_of_voxel.assign (voxelized.grid.size(), no_plane);
  for (const HoughPlane& plane : planes) {
    const auto label = static_cast<std::int32_t> (voxels.planes.size());
    voxels.planes.push_back (plane.plane);
    for (const std::uint32_t c : plane.clusters) {
      const CoplanarCluster& cluster = found.clusters[c];
      for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
        const std::uint32_t voxel = voxel_of_point[found.points[i].index];
        if (voxels.plane_of_voxel[voxel] == no_plane)
          voxels.plane_of_voxel[voxel] = label;
      }
    }
  }
  return voxels;
}

/** Takes voxels off planes that their points are not on. */
void
releaseVoxels (const VoxelGrid& grid, BoundedPlanes& planes)
{
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (std::int32_t& plane = planes.plane_of_voxel[i]; plane != no_plane) {
      const auto p = static_cast<std::size_t> (plane);
      const double limit = noises_of_a_voxel * planes.noise[p];
      if (meanSquaredDistance (grid.moments[i], planes.planes[p]) > limit * limit)
        plane = no_plane;
    }
}

/** Grows and merges planes on their voxels. */
void
settleVoxels (const VoxelGrid& grid,
              const KernelHoughTransformParameters& parameters,
              BoundedPlanes& planes)
{
  measureNoise (grid, parameters.threads, planes);
  releaseVoxels (grid, planes);
  growPlanes (grid, parameters.distance_threshold, parameters.threads, planes);
  renumberPlanes (mergePlanes (momentsOfPlanes (grid, planes), mergingOf (parameters)),
                  planes);
  measureNoise (grid, parameters.threads, planes);
}

/** Replaces each least squares plane by the plane its points were assigned to, with the
 * centroid moved onto it: the first one's where planes were merged. */
void
restorePlanes (MergedPlanes& merged, const std::vector<Plane>& planes)
{
  for (std::size_t i = planes.size(); i-- > 0;)
    if (const std::int32_t group = merged.merged_into[i]; group != no_plane)
      merged.fits[static_cast<std::size_t> (group)].plane = planes[i];
  for (PlaneFit& fit : merged.fits)
    fit.centroid -= fit.plane.distance (fit.centroid) * fit.plane.normal;
}

} // namespace

LabelledPlanes
assignToUnboundedPlanes (const Points& points,
                         const OctreeClusters& found,
                         const std::vector<HoughPlane>& hough_planes,
                         const KernelHoughTransformParameters& parameters,
                         StageDurations& durations)
{
  StageClock clock;
  const std::vector<Plane> planes = withoutClusters (hough_planes);
  AssignedPoints assigned;
  assigned.labels = assignOctreePoints (found, points.size(), planes, parameters);
  clock.lap (durations.assignment);
  assigned.moments =
      momentsOfLabels (points, assigned.labels, planes.size(), parameters.threads);
  LabelledPlanes merged =
      mergeAssigned (std::move (assigned), mergingOf (parameters), parameters.threads);
  restorePlanes (merged.planes, planes);
  clock.lap (durations.merging);
  return merged;
}

LabelledPlanes
assignToOutlinedPlanes (const Points& points,
                        const OctreeClusters& found,
                        const std::vector<HoughPlane>& hough_planes,
                        const KernelHoughTransformParameters& parameters,
                        StageDurations& durations)
{
  if (hough_planes.empty())
    return {Labels (points.size(), no_plane), {}, 0};
  constexpr double follows_noise_up_to = 4.0;
  StageClock clock;
  VoxelizedPoints voxelized =
      voxelize (points, voxelSizeFor (points, wanted_voxels), parameters.threads);
  connect (voxelized.grid, parameters.threads);
  clock.lap (durations.search);
  BoundedPlanes planes = voxelsOfClusters (hough_planes, found, voxelized);
  settleVoxels (voxelized.grid, parameters, planes);
  clock.lap (durations.merging);
  AssignedPoints assigned{Labels (points.size(), no_plane), {}};
  assignToBoundedPlanes (points,
                         voxelized.order,
                         voxelized.grid,
                         planes,
                         parameters.distance_threshold,
                         follows_noise_up_to,
                         parameters.threads,
                         {},
                         assigned);
  MergingParameters keep_apart;
  keep_apart.enabled = false;
  LabelledPlanes kept =
      mergeAssigned (std::move (assigned), keep_apart, parameters.threads);
  clock.lap (durations.assignment);
  return kept;
}

} // namespace pcl_ops::internal

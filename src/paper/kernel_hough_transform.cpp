// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/stage_clock.h"
#include "cloud/voxel_size.h"
#include "detection/labeled_planes.h"
#include "paper/hough_planes.h"
#include "voxels/bounded_assignment.h"
#include "voxels/bounded_planes.h"
#include "voxels/plane_growing.h"
#include <pcl_ops/kernel_hough_transform.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl_ops {

namespace internal {
namespace {

// A cloud is divided into about so many voxels, which tell where planes end; chosen by
// hand.
constexpr double wanted_voxels = 9000.0;

/** Bounds planes by the voxels of their clusters. Each voxel goes to the plane of the
 * first cluster that has a point in it. */
BoundedPlanes
boundedByClusters (const std::vector<HoughPlane>& planes,
                   const OctreeClusters& octree,
                   const VoxelGrid& grid)
{
  const Indices voxel_of_point = voxelsOfPoints (grid);
  BoundedPlanes bounded;
  bounded.plane_of_voxel.assign (grid.size(), no_plane);
  for (const HoughPlane& plane : planes) {
    const auto label = static_cast<std::int32_t> (bounded.planes.size());
    bounded.planes.push_back (plane.plane);
    for (const std::uint32_t c : plane.clusters) {
      const CoplanarCluster& cluster = octree.clusters[c];
      for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
        const std::uint32_t voxel = voxel_of_point[octree.points[i].index];
        if (bounded.plane_of_voxel[voxel] == no_plane)
          bounded.plane_of_voxel[voxel] = label;
      }
    }
  }
  return bounded;
}

/** Removes voxels from their plane if the rms distance of their points to the plane
 * exceeds max_voxel_rms_in_noises times the noise of the plane. */
void
releaseVoxels (const VoxelGrid& grid, BoundedPlanes& planes)
{
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (std::int32_t& plane = planes.plane_of_voxel[i]; plane != no_plane) {
      const double max_rms = max_voxel_rms_in_noises * planes.noise[plane];
      if (meanSquaredDistance (grid.moments[i], planes.planes[plane]) >
          max_rms * max_rms)
        plane = no_plane;
    }
}

void
growAndMergeOnVoxels (const VoxelGrid& grid,
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

/** Replaces each least squares plane by the plane its points were assigned to; where
 * planes were merged, by the first of them: the loop runs backwards, so that the first
 * one is written last. The centroid is moved onto that plane. */
void
restorePlanes (MergedPlanes& merged, const std::vector<Plane>& planes)
{
  for (std::size_t i = planes.size(); i-- > 0;)
    if (const std::int32_t group = merged.merged_into[i]; group != no_plane)
      merged.fits[static_cast<std::size_t> (group)].plane = planes[i];
  for (PlaneFit& fit : merged.fits)
    fit.centroid -= fit.plane.distance (fit.centroid) * fit.plane.normal;
}

/** Assigns points to unbounded planes (\ref assignPoints), and merges the planes (\ref
 * mergePlanes). Points are assigned in the order of the octree, in which the blocks of
 * \ref assignPoints are small: most planes are too far from a block and are skipped. */
LabeledPlanes
assignAndMergeUnbounded (const Points& points,
                         const OctreeClusters& octree,
                         const std::vector<HoughPlane>& hough_planes,
                         const KernelHoughTransformParameters& parameters,
                         StageDurations& durations)
{
  const unsigned threads = parameters.threads;
  const double theta_h = *parameters.distance_threshold;
  StageClock clock;
  std::vector<Plane> planes;
  for (const HoughPlane& plane : hough_planes)
    planes.push_back (plane.plane);
  Coordinates in_octree_order;
  for (const OctreePoint& point : octree.points)
    in_octree_order.add (point.x, point.y, point.z);
  const Labels labels =
      assignPoints (in_octree_order, planes, theta_h, AssignmentRule::First, threads);
  AssignedPoints assigned{Labels (points.size(), no_plane), {}};
  for (std::size_t i = 0; i < labels.size(); ++i)
    assigned.labels[octree.points[i].index] = labels[i];
  clock.lap (durations.assignment);
  assigned.moments = momentsOfLabels (points, assigned.labels, planes.size(), threads);
  LabeledPlanes merged =
      mergePlanesOf (std::move (assigned), mergingOf (parameters), threads);
  restorePlanes (merged.planes, planes);
  clock.lap (durations.merging);
  return merged;
}

/** Merges planes that are bounded by voxels: those of their clusters, and those that
 * they grow into. Then assigns points to them (\ref assignToBoundedPlanes). */
LabeledPlanes
mergeAndAssignBounded (const Points& points,
                       const OctreeClusters& octree,
                       const std::vector<HoughPlane>& hough_planes,
                       const KernelHoughTransformParameters& parameters,
                       StageDurations& durations)
{
  if (hough_planes.empty())
    return {Labels (points.size(), no_plane), {}, 0};
  // Largest distance of a point to its plane, in units of the plane's noise; chosen by
  // hand.
  constexpr double assignment_noise_factor = 4.0;
  StageClock clock;
  VoxelGrid grid =
      voxelize (points, voxelSizeFor (points, wanted_voxels), parameters.threads);
  connect (grid, parameters.threads);
  clock.lap (durations.search);
  BoundedPlanes planes = boundedByClusters (hough_planes, octree, grid);
  growAndMergeOnVoxels (grid, parameters, planes);
  clock.lap (durations.merging);
  AssignedPoints assigned{Labels (points.size(), no_plane), {}};
  const std::vector<char> left_out_voxels; // none
  assignToBoundedPlanes (points,
                         grid,
                         planes,
                         parameters.distance_threshold,
                         assignment_noise_factor,
                         parameters.threads,
                         left_out_voxels,
                         assigned);
  MergingParameters keep_apart;
  keep_apart.enabled = false;
  LabeledPlanes kept =
      mergePlanesOf (std::move (assigned), keep_apart, parameters.threads);
  clock.lap (durations.assignment);
  return kept;
}

LabeledPlanes
detectByVotes (const Points& points,
               const KernelHoughTransformParameters& parameters,
               StageDurations& durations)
{
  const double theta_h = *parameters.distance_threshold;
  StageClock clock;
  // octree: nodes of roughly coplanar points
  const OctreeClusters octree =
      findCoplanarClusters (points, parameters.clusters, parameters.threads);
  clock.lap (durations.search);
  // accumulator ball: Gaussian kernels vote for (rho, phi, theta), peaks are planes
  std::vector<HoughPlane> planes =
      voteForPlanes (octree, parameters.phi_num, parameters.rho_num);
  // refits planes to their clusters, away from the centers of bins
  if (parameters.refit.enabled)
    planes = refitPlanes (planes, octree, parameters.refit.min_share, theta_h);
  clock.lap (durations.extraction);
  // assigns points to planes and merges planes by the coplanarity test of the OPS
  // paper; bounded planes are merged first
  LabeledPlanes found =
      parameters.refit.enabled
          ? mergeAndAssignBounded (points, octree, planes, parameters, durations)
          : assignAndMergeUnbounded (points, octree, planes, parameters, durations);
  found.planes_before_merging = planes.size();
  return found;
}

} // namespace
} // namespace internal

detail::Detection
detail::detect (const DetectorInput& input,
                const KernelHoughTransformParameters& parameters)
{
  using namespace internal;
  return detectInFinitePoints (
      input, parameters, [&] (const auto& points, auto& durations) {
        return detectByVotes (points, parameters, durations);
      });
}

KernelHoughTransformParameters::KernelHoughTransformParameters()
{
  // Clusters has the published values, 5 and 25, which lose the surfaces of noisy
  // clouds. paper() restores them.
  clusters.first_level = 3;
  clusters.s_alpha = 15.0;
}

KernelHoughTransformParameters
KernelHoughTransformParameters::paper()
{
  KernelHoughTransformParameters parameters;
  parameters.phi_num = 80;
  parameters.rho_num = 800;
  parameters.clusters = Clusters();
  parameters.refit.enabled = false;
  parameters.distance_threshold = 0.05;
  parameters.merging.enabled = false;
  return parameters;
}

std::string
validate (const KernelHoughTransformParameters& parameters)
{
  // They bound the memory: the ball has up to 1.3 million directions (4 / pi
  // max_phi^2), and a direction in use has rho_num bins of 4 bytes.
  constexpr int max_phi = 1000;
  constexpr int max_rho = 10000;
  // Limits the depth of recursive calls. Nodes of deeper levels would be smaller than
  // any noise.
  constexpr int max_levels = 60;
  const KernelHoughTransformParameters::Clusters& clusters = parameters.clusters;
  if (parameters.phi_num < 2 || parameters.phi_num > max_phi)
    return "phi_num must be between 2 and " + std::to_string (max_phi);
  if (parameters.rho_num < 2 || parameters.rho_num > max_rho)
    return "rho_num must be between 2 and " + std::to_string (max_rho);
  if (clusters.min_samples < 3)
    return "a cluster needs at least three samples";
  if (clusters.first_level < 0 || clusters.max_level < clusters.first_level)
    return "s_level must be 0 or more and no more than the deepest level";
  if (clusters.max_level > max_levels)
    return "the deepest level must be no more than " + std::to_string (max_levels);
  if (!(clusters.s_alpha > 0.0 && clusters.s_beta > 0.0))
    return "s_alpha and s_beta must be above 0";
  if (!(parameters.refit.min_share >= 0.0 && parameters.refit.min_share <= 1.0))
    return "the smallest share of a plane must be between 0 and 1";
  if (!parameters.distance_threshold)
    return "the distance threshold must be a length above 0";
  return validate (static_cast<const PlaneDetectorParameters&> (parameters));
}

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/stage_clock.h"
#include "detection/labelled_planes.h"
#include "kht/cluster_assignment.h"
#include "kht/hough_planes.h"
#include "kht/octree_clusters.h"
#include <pcl_ops/kernel_hough_transform.h>

#include <string>
#include <utility>

namespace pcl_ops {

namespace internal {
namespace {

LabelledPlanes
detectByVotes (const Points& points,
               const KernelHoughTransformParameters& parameters,
               StageDurations& durations)
{
  const double theta_h = *parameters.distance_threshold;
  StageClock clock;
  // octree: nodes of approximately coplanar points
  const OctreeClusters clusters =
      findCoplanarClusters (points, parameters.clusters, parameters.threads);
  clock.lap (durations.search);
  // accumulator ball: Gaussian kernels vote for (rho, phi, theta), peaks are planes
  std::vector<HoughPlane> planes =
      voteForPlanes (clusters, parameters.phi_num, parameters.rho_num);
  // the planes freed from the bins
  if (parameters.refit.enabled)
    planes = refitPlanes (planes, clusters, parameters.refit.min_share, theta_h);
  clock.lap (durations.extraction);
  // every point to a plane, and the coplanarity test of the OPS paper on each pair
  LabelledPlanes found =
      parameters.refit.enabled
          ? assignToOutlinedPlanes (points, clusters, planes, parameters, durations)
          : assignToUnboundedPlanes (points, clusters, planes, parameters, durations);
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

namespace {

constexpr int max_phi = 1000;
constexpr int max_rho = 10000;
// Each level of an octree is a call within a call; nodes are below any noise long
// before.
constexpr int max_levels = 60;

} // namespace

KernelHoughTransformParameters::KernelHoughTransformParameters()
{
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

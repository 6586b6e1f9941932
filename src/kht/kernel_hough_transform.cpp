// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/kernel_hough_transform.h>

#include <string>

namespace pcl_ops {
namespace {

constexpr int most_phi = 1000;
constexpr int most_rho = 10000;

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
  parameters.clusters = OctreeClusterParameters();
  parameters.refit.enabled = false;
  parameters.bounded = false;
  parameters.assignment = AssignmentRule::First;
  parameters.distance_threshold = 0.05;
  parameters.merging.enabled = false;
  return parameters;
}

std::string
problemOf (const KernelHoughTransformParameters& parameters)
{
  const OctreeClusterParameters& clusters = parameters.clusters;
  if (parameters.phi_num < 2 || parameters.phi_num > most_phi)
    return "phi_num must be between 2 and " + std::to_string (most_phi);
  if (parameters.rho_num < 2 || parameters.rho_num > most_rho)
    return "rho_num must be between 2 and " + std::to_string (most_rho);
  if (clusters.min_samples < 3)
    return "a cluster needs at least three samples";
  if (clusters.first_level < 0 || clusters.deepest_level < clusters.first_level)
    return "s_level must be 0 or more and no more than the deepest level";
  if (!(clusters.s_alpha > 0.0 && clusters.s_beta > 0.0))
    return "s_alpha and s_beta must be above 0";
  if (!(parameters.refit.min_share >= 0.0 && parameters.refit.min_share <= 1.0))
    return "the smallest share of a plane must be between 0 and 1";
  return problemOf (static_cast<const PlaneDetectorParameters&> (parameters));
}

std::vector<HoughPlane>
houghPlanes (const OctreeClusters& found,
             const KernelHoughTransformParameters& parameters)
{
  const std::vector<HoughPlane> voted =
      voteForPlanes (found, parameters.phi_num, parameters.rho_num);
  return parameters.refit.enabled ? refitPlanes (voted,
                                                 found,
                                                 parameters.refit.min_share,
                                                 parameters.distance_threshold)
                                  : voted;
}

void
restorePlanes (MergedPlanes& merged, const std::vector<Plane>& planes)
{
  std::vector<bool> is_restored (merged.fits.size(), false);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (merged.merged_into[i] == no_plane)
      continue;
    const auto group = static_cast<std::size_t> (merged.merged_into[i]);
    if (is_restored[group])
      continue;
    is_restored[group] = true;
    PlaneFit& fit = merged.fits[group];
    fit.plane = planes[i];
    fit.centroid -= planes[i].distance (fit.centroid) * planes[i].normal;
  }
}

} // namespace pcl_ops

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_filter.h>
#include <pcl_ops/plane_matching.h>
#include <pcl_ops/up_axis.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl_ops::python {

/** \brief Which planes are horizontal and vertical, alone. */
struct OrientationParameters : PlaneDetectorParameters {};

/** \brief Those of merging, with the above for the merged planes. */
struct MergePlanesParameters : PlaneDetectorParameters {};

/** \defgroup names What Python calls the values of enumerations. */
/** @{ */
template <typename Enum>
using Names = std::vector<std::pair<const char*, Enum>>;
template <typename Enum>
inline const Names<Enum> names = {};

template <>
inline const Names<Sampling> names<Sampling> = {{"points", Sampling::Points},
                                                {"surfels", Sampling::Surfels}};
template <>
inline const Names<PaperParameters::Strategy> names<PaperParameters::Strategy> = {
    {"detect_then_divide", PaperParameters::Strategy::DetectThenDivide},
    {"divide_then_detect", PaperParameters::Strategy::DivideThenDetect}};
template <>
inline const Names<PaperParameters::Verification> names<PaperParameters::Verification> =
    {{"samples", PaperParameters::Verification::Samples},
     {"all_points", PaperParameters::Verification::AllPoints}};
template <>
inline const Names<AssignmentRule> names<AssignmentRule> = {
    {"nearest", AssignmentRule::Nearest}, {"first", AssignmentRule::First}};
template <>
inline const Names<FastSamplingPlaneFilteringParameters::Local::Inliers>
    names<FastSamplingPlaneFilteringParameters::Local::Inliers> = {
        {"sphere", FastSamplingPlaneFilteringParameters::Local::Inliers::Sphere},
        {"samples", FastSamplingPlaneFilteringParameters::Local::Inliers::Samples}};
template <>
inline const Names<Orientation> names<Orientation> = {
    {"horizontal", Orientation::Horizontal},
    {"vertical", Orientation::Vertical},
    {"other", Orientation::Other}};
/** @} */

/** \defgroup visit Calls \c at (name, member) for each parameter, by the name Python
 * has for it. The only list of them: values, defaults, types and errors come from it.
 */
/** @{ */
template <typename At>
void
visitOrientation (PlaneDetectorParameters& p, const At& at)
{
  at ("up", p.up_axis);
  at ("angle_tolerance", p.angle_tolerance);
}

template <typename At>
void
visit (MergingParameters& p, const At& at)
{
  at ("enabled", p.enabled);
  at ("angle_threshold", p.angle_threshold);
  at ("distance_threshold", p.distance_threshold);
  at ("noise_factor", p.noise_factor);
}

template <typename At>
void
visit (OrientedPointSamplingParameters::Surfels& p, const At& at)
{
  at ("voxel_size", p.voxel_size);
  at ("resolutions", p.resolutions);
  at ("min_average_voxels", p.min_average_voxels);
  at ("noise_factor", p.noise_factor);
  at ("angle_threshold", p.angle_threshold);
  at ("sure_thickness", p.sure_thickness);
  at ("max_thickness", p.max_thickness);
  at ("absorption_noise_factor", p.absorption_noise_factor);
  at ("assignment_noise_factor", p.assignment_noise_factor);
}

template <typename At>
void
visit (KernelHoughTransformParameters::Clusters& p, const At& at)
{
  at ("min_samples", p.min_samples);
  at ("first_level", p.first_level);
  at ("s_alpha", p.s_alpha);
  at ("s_beta", p.s_beta);
  at ("max_level", p.max_level);
}

template <typename At>
void
visit (KernelHoughTransformParameters::Refit& p, const At& at)
{
  at ("enabled", p.enabled);
  at ("min_share", p.min_share);
}

/** \brief Those of a struct within another: its name before theirs. */
template <typename Inner, typename At>
void
visitWithin (const std::string& prefix, Inner& inner, const At& at)
{
  visit (inner,
         [&] (const std::string& name, auto& value) { at (prefix + name, value); });
}

/** \brief What all detectors have. */
template <typename At>
void
visitShared (PlaneDetectorParameters& p, const At& at)
{
  visitOrientation (p, at);
  at ("distance_threshold", p.distance_threshold);
  at ("seed", p.seed);
  at ("threads", p.threads);
  visitWithin ("merging_", p.merging, at);
}

template <typename At>
void
visit (OrientedPointSamplingParameters& p, const At& at)
{
  at ("sampling", p.sampling);
  at ("sampling_rate", p.sampling_rate);
  at ("k", p.k);
  at ("normal_sigma", p.paper_only.normal_sigma);
  at ("min_inliers", p.min_inliers);
  at ("probability", p.paper_only.probability);
  at ("strategy", p.paper_only.strategy);
  at ("verification", p.paper_only.verification);
  at ("assignment_rule", p.paper_only.assignment_rule);
  at ("local_optimization", p.paper_only.local_optimization);
  visitWithin ("surfels_", p.surfels, at);
  visitShared (p, at);
}

template <typename At>
void
visit (FastSamplingPlaneFilteringParameters& p, const At& at)
{
  at ("inner_radius", p.local.inner_radius);
  at ("outer_radius", p.local.outer_radius);
  at ("local_samples", p.local.local_samples);
  at ("min_inlier_fraction", p.local.min_inlier_fraction);
  at ("local_inliers", p.local.inliers);
  at ("max_inliers_per_point", p.local.max_inliers_per_point);
  at ("max_hypotheses_per_point", p.local.max_hypotheses_per_point);
  at ("max_visits_per_point", p.local.max_visits_per_point);
  visitShared (p, at);
}

template <typename At>
void
visit (KernelHoughTransformParameters& p, const At& at)
{
  at ("phi_num", p.phi_num);
  at ("rho_num", p.rho_num);
  visitWithin ("clusters_", p.clusters, at);
  visitWithin ("refit_", p.refit, at);
  visitShared (p, at);
}

template <typename At>
void
visit (OrientationParameters& p, const At& at)
{
  visitOrientation (p, at);
}

template <typename At>
void
visit (MergePlanesParameters& p, const At& at)
{
  visitOrientation (p, at);
  visit (p.merging, at);
}

template <typename At>
void
visit (PlaneFilter& p, const At& at)
{
  at ("orientation", p.orientation);
  at ("direction", p.direction);
  at ("direction_tolerance", p.direction_tolerance);
  at ("min_points", p.min_points);
  at ("min_area", p.min_area);
  at ("min_width", p.min_width);
  at ("max_area", p.max_area);
  at ("max_width", p.max_width);
  at ("max_planes", p.max_planes);
}

template <typename At>
void
visit (PlaneMatchingParameters& p, const At& at)
{
  at ("rotation_error", p.rotation_error);
  at ("translation_error", p.translation_error);
  at ("min_overlap", p.min_overlap);
}

template <typename At>
void
visit (UpAxisParameters& p, const At& at)
{
  at ("angle_tolerance", p.angle_tolerance);
  at ("min_share", p.min_share);
  at ("min_confidence", p.min_confidence);
}

template <typename At>
void
visit (PlaneEdgeParameters& p, const At& at)
{
  at ("reach", p.reach);
  at ("max_gap", p.max_gap);
  at ("min_length", p.min_length);
  at ("min_angle", p.min_angle);
}
/** @} */

} // namespace pcl_ops::python

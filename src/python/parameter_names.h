// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/buildings/floor_plan.h>
#include <pcl_ops/buildings/plane_regularization.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_filter.h>
#include <pcl_ops/plane_matching.h>
#include <pcl_ops/up_axis.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl_ops::python {

using PaperStrategy = PaperParameters::Strategy;
using PaperVerification = PaperParameters::Verification;
using LocalInliers = FastSamplingPlaneFilteringParameters::Local::Inliers;

/** \brief Words, each with the value of an enumeration that it stands for. */
template <typename E>
using Words = std::vector<std::pair<std::string, E>>;

/** \brief The words that stand for values of enumerations in Python. */
inline const std::tuple words = {
    Words<Sampling>{{"points", Sampling::Points},
                    {"surfels", Sampling::Surfels},
                    {"neighborhoods", Sampling::Neighborhoods},
                    {"automatic", Sampling::Automatic}},
    Words<PaperStrategy>{{"detect_then_divide", PaperStrategy::DetectThenDivide},
                         {"divide_then_detect", PaperStrategy::DivideThenDetect}},
    Words<PaperVerification>{{"samples", PaperVerification::Samples},
                             {"all_points", PaperVerification::AllPoints}},
    Words<AssignmentRule>{{"nearest", AssignmentRule::Nearest},
                          {"first", AssignmentRule::First}},
    Words<LocalInliers>{{"sphere", LocalInliers::Sphere},
                        {"samples", LocalInliers::Samples}},
    Words<Orientation>{{"horizontal", Orientation::Horizontal},
                       {"vertical", Orientation::Vertical},
                       {"other", Orientation::Other}}};

/** \brief Parameters of merge_planes: those of merging, and those that name
 * orientations of merged planes. A type of its own, as its parameters have other names
 * in Python. */
struct MergePlanesParameters : PlaneDetectorParameters {};

/** \brief A function object with the calls of several lambdas as its overloads. */
template <typename... Lambdas>
struct Overloaded : Lambdas... {
  using Lambdas::operator()...;
};
template <typename... Lambdas>
Overloaded (Lambdas...) -> Overloaded<Lambdas...>;

/** \brief Visits the parameters by which orientations of planes are named. */
inline const auto visit_orientations = [] (PlaneDetectorParameters& p,
                                           const auto& visit) {
  visit ("up", p.up_axis);
  visit ("angle_tolerance", p.angle_tolerance);
};

/** \brief Visits the parameters that all detectors have. */
inline const auto visit_parameters_of_all_detectors = [] (PlaneDetectorParameters& p,
                                                          const auto& visit) {
  visit ("distance_threshold", p.distance_threshold);
  visit ("min_points", p.min_points);
  visit ("seed", p.seed);
  visit ("threads", p.threads);
  visit ("merging_enabled", p.merging.enabled);
  visit ("merging_angle_threshold", p.merging.angle_threshold);
  visit ("merging_distance_threshold", p.merging.distance_threshold);
  visit ("merging_noise_factor", p.merging.noise_factor);
  visit_orientations (p, visit);
};

/** \brief Calls visit (name in Python, member) for each parameter of a struct. Names of
 * members of a nested struct mostly begin with the name of that struct. The overload
 * for PlaneDetectorParameters itself is visit_orientations: evaluate, which has this
 * struct, uses no other parameters of it. */
inline const Overloaded visit_parameters = {
    visit_orientations,
    [] (MergePlanesParameters& p, const auto& visit) {
      visit ("enabled", p.merging.enabled);
      visit ("angle_threshold", p.merging.angle_threshold);
      visit ("distance_threshold", p.merging.distance_threshold);
      visit ("noise_factor", p.merging.noise_factor);
      visit_orientations (p, visit);
    },
    [] (OrientedPointSamplingParameters& p, const auto& visit) {
      visit ("sampling", p.sampling);
      visit ("sampling_rate", p.sampling_rate);
      visit ("k", p.k);
      visit ("min_samples", p.min_samples);
      visit ("normal_sigma", p.paper_only.normal_sigma);
      visit ("probability", p.paper_only.probability);
      visit ("strategy", p.paper_only.strategy);
      visit ("verification", p.paper_only.verification);
      visit ("assignment_rule", p.paper_only.assignment_rule);
      visit ("local_optimization", p.paper_only.local_optimization);
      visit ("surfels_voxel_size", p.surfels.voxel_size);
      visit ("surfels_resolutions", p.surfels.resolutions);
      visit ("surfels_min_average_voxels", p.surfels.min_average_voxels);
      visit ("surfels_noise_factor", p.surfels.noise_factor);
      visit ("surfels_angle_threshold", p.surfels.angle_threshold);
      visit ("surfels_sure_thickness", p.surfels.sure_thickness);
      visit ("surfels_max_thickness", p.surfels.max_thickness);
      visit ("surfels_absorption_noise_factor", p.surfels.absorption_noise_factor);
      visit ("surfels_assignment_noise_factor", p.surfels.assignment_noise_factor);
      visit_parameters_of_all_detectors (p, visit);
    },
    [] (FastSamplingPlaneFilteringParameters& p, const auto& visit) {
      visit ("inner_radius", p.local.inner_radius);
      visit ("outer_radius", p.local.outer_radius);
      visit ("local_samples", p.local.local_samples);
      visit ("min_inlier_fraction", p.local.min_inlier_fraction);
      visit ("local_inliers", p.local.inliers);
      visit ("max_inliers_per_point", p.local.max_inliers_per_point);
      visit ("max_hypotheses_per_point", p.local.max_hypotheses_per_point);
      visit ("max_visits_per_point", p.local.max_visits_per_point);
      visit_parameters_of_all_detectors (p, visit);
    },
    [] (KernelHoughTransformParameters& p, const auto& visit) {
      visit ("phi_num", p.phi_num);
      visit ("rho_num", p.rho_num);
      visit ("clusters_min_samples", p.clusters.min_samples);
      visit ("clusters_first_level", p.clusters.first_level);
      visit ("clusters_s_alpha", p.clusters.s_alpha);
      visit ("clusters_s_beta", p.clusters.s_beta);
      visit ("clusters_max_level", p.clusters.max_level);
      visit ("refit_enabled", p.refit.enabled);
      visit ("refit_min_share", p.refit.min_share);
      visit_parameters_of_all_detectors (p, visit);
    },
    [] (PlaneFilter& p, const auto& visit) {
      visit ("orientation", p.orientation);
      visit ("direction", p.direction);
      visit ("direction_tolerance", p.direction_tolerance);
      visit ("slope", p.slope);
      visit ("up", p.up_axis);
      visit ("min_points", p.min_points);
      visit ("min_area", p.min_area);
      visit ("min_width", p.min_width);
      visit ("max_area", p.max_area);
      visit ("max_width", p.max_width);
      visit ("size", p.size);
      visit ("max_planes", p.max_planes);
    },
    [] (PlaneMatchingParameters& p, const auto& visit) {
      visit ("rotation_error", p.rotation_error);
      visit ("translation_error", p.translation_error);
      visit ("min_overlap", p.min_overlap);
    },
    [] (UpAxisParameters& p, const auto& visit) {
      visit ("angle_tolerance", p.angle_tolerance);
      visit ("min_share", p.min_share);
      visit ("min_confidence", p.min_confidence);
    },
    [] (PlaneEdgeParameters& p, const auto& visit) {
      visit ("reach", p.reach);
      visit ("max_gap", p.max_gap);
      visit ("min_length", p.min_length);
      visit ("min_angle", p.min_angle);
    },
    [] (PlaneRegularizationParameters& p, const auto& visit) {
      visit ("max_angle", p.max_angle);
      visit ("max_offset", p.max_offset);
      visit ("max_displacement", p.max_displacement);
    },
    [] (FloorPlanParameters& p, const auto& visit) {
      visit ("cut_height", p.cut_height);
      visit ("min_opening", p.min_opening);
      visit ("max_opening", p.max_opening);
      visit ("max_snap", p.max_snap);
      visit ("min_room", p.min_room);
      visit ("meter", p.meter);
    }};

} // namespace pcl_ops::python

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "module.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_filter.h>
#include <pcl_ops/plane_matching.h>
#include <pcl_ops/up_axis.h>

namespace pcl_ops::python {

namespace {

/** \brief A struct of parameters, which Python copies and sets. The documentation of a
 * field is what it has to be; those of a struct within it, which has none, have the
 * name of that before theirs. */
template <typename P, typename... Base>
py::class_<P, Base...>
parameters (py::module_& module, const char* name)
{
  return py::class_<P, Base...> (module, name)
      .def (py::init<>())
      .def (py::init<const P&>())
      .def ("problem", [] (const P& p) { return validate (p); });
}

void
defineEnumerations (py::module_& module)
{
  py::enum_<Sampling> (module, "Sampling")
      .value ("points", Sampling::Points)
      .value ("surfels", Sampling::Surfels);
  using Strategy = PaperParameters::Strategy;
  py::enum_<Strategy> (module, "Strategy")
      .value ("detect_then_divide", Strategy::DetectThenDivide)
      .value ("divide_then_detect", Strategy::DivideThenDetect);
  using Verification = PaperParameters::Verification;
  py::enum_<Verification> (module, "Verification")
      .value ("samples", Verification::Samples)
      .value ("all_points", Verification::AllPoints);
  py::enum_<AssignmentRule> (module, "AssignmentRule")
      .value ("nearest", AssignmentRule::Nearest)
      .value ("first", AssignmentRule::First);
  using LocalInliers = FastSamplingPlaneFilteringParameters::Local::Inliers;
  py::enum_<LocalInliers> (module, "LocalInliers")
      .value ("sphere", LocalInliers::Sphere)
      .value ("samples", LocalInliers::Samples);
  py::enum_<Orientation> (module, "Orientation")
      .value ("horizontal", Orientation::Horizontal)
      .value ("vertical", Orientation::Vertical)
      .value ("other", Orientation::Other);
}

void
defineInner (py::module_& module)
{
  using Merging = MergingParameters;
  py::class_<Merging> (module, "Merging")
      .def_readwrite ("enabled", &Merging::enabled, "bool")
      .def_readwrite ("angle_threshold", &Merging::angle_threshold, "float")
      .def_readwrite (
          "distance_threshold", &Merging::distance_threshold, "Optional[float]")
      .def_readwrite ("noise_factor", &Merging::noise_factor, "Optional[float]");
  using Paper = PaperParameters;
  py::class_<Paper> (module, "Paper")
      .def_readwrite ("normal_sigma", &Paper::normal_sigma, "Optional[float]")
      .def_readwrite ("probability", &Paper::probability, "float")
      .def_readwrite ("strategy", &Paper::strategy, "Strategy")
      .def_readwrite ("verification", &Paper::verification, "Verification")
      .def_readwrite ("assignment_rule", &Paper::assignment_rule, "AssignmentRule")
      .def_readwrite ("local_optimization", &Paper::local_optimization, "bool");
  using Surfels = OrientedPointSamplingParameters::Surfels;
  py::class_<Surfels> (module, "Surfels")
      .def_readwrite ("voxel_size", &Surfels::voxel_size, "Optional[float]")
      .def_readwrite ("resolutions", &Surfels::resolutions, "int")
      .def_readwrite ("min_average_voxels", &Surfels::min_average_voxels, "float")
      .def_readwrite ("noise_factor", &Surfels::noise_factor, "float")
      .def_readwrite ("angle_threshold", &Surfels::angle_threshold, "float")
      .def_readwrite ("sure_thickness", &Surfels::sure_thickness, "float")
      .def_readwrite ("max_thickness", &Surfels::max_thickness, "float")
      .def_readwrite (
          "absorption_noise_factor", &Surfels::absorption_noise_factor, "float")
      .def_readwrite (
          "assignment_noise_factor", &Surfels::assignment_noise_factor, "float");
  using Local = FastSamplingPlaneFilteringParameters::Local;
  py::class_<Local> (module, "Local")
      .def_readwrite ("inner_radius", &Local::inner_radius, "float")
      .def_readwrite ("outer_radius", &Local::outer_radius, "float")
      .def_readwrite ("local_samples", &Local::local_samples, "int")
      .def_readwrite ("min_inlier_fraction", &Local::min_inlier_fraction, "float")
      .def_readwrite ("local_inliers", &Local::inliers, "LocalInliers")
      .def_readwrite ("max_inliers_per_point", &Local::max_inliers_per_point, "float")
      .def_readwrite (
          "max_hypotheses_per_point", &Local::max_hypotheses_per_point, "float")
      .def_readwrite ("max_visits_per_point", &Local::max_visits_per_point, "float");
  using Clusters = KernelHoughTransformParameters::Clusters;
  py::class_<Clusters> (module, "Clusters")
      .def_readwrite ("min_samples", &Clusters::min_samples, "int")
      .def_readwrite ("first_level", &Clusters::first_level, "int")
      .def_readwrite ("s_alpha", &Clusters::s_alpha, "float")
      .def_readwrite ("s_beta", &Clusters::s_beta, "float")
      .def_readwrite ("max_level", &Clusters::max_level, "int");
  using Refit = KernelHoughTransformParameters::Refit;
  py::class_<Refit> (module, "Refit")
      .def_readwrite ("enabled", &Refit::enabled, "bool")
      .def_readwrite ("min_share", &Refit::min_share, "float");
}

/** \brief What all detectors have behind their own. */
template <typename Class>
void
defineShared (Class&& detector)
{
  using P = PlaneDetectorParameters;
  detector
      .def_readwrite ("distance_threshold", &P::distance_threshold, "Optional[float]")
      .def_readwrite ("seed", &P::seed, "int")
      .def_readwrite ("threads", &P::threads, "int")
      .def_readwrite ("merging_", &P::merging)
      .def_static ("paper", &std::decay_t<Class>::type::paper);
}

void
defineDetectors (py::module_& module)
{
  using Base = PlaneDetectorParameters;
  using Ops = OrientedPointSamplingParameters;
  defineShared (parameters<Ops, Base> (module, "ops")
                    .def_readwrite ("sampling", &Ops::sampling, "Sampling")
                    .def_readwrite ("sampling_rate", &Ops::sampling_rate, "float")
                    .def_readwrite ("k", &Ops::k, "int")
                    .def_readwrite ("min_inliers", &Ops::min_inliers, "int")
                    .def_readwrite ("", &Ops::paper_only)
                    .def_readwrite ("surfels_", &Ops::surfels));
  using Fspf = FastSamplingPlaneFilteringParameters;
  defineShared (
      parameters<Fspf, Base> (module, "fspf").def_readwrite ("", &Fspf::local));
  using Kht = KernelHoughTransformParameters;
  defineShared (parameters<Kht, Base> (module, "kht")
                    .def_readwrite ("phi_num", &Kht::phi_num, "int")
                    .def_readwrite ("rho_num", &Kht::rho_num, "int")
                    .def_readwrite ("clusters_", &Kht::clusters)
                    .def_readwrite ("refit_", &Kht::refit));
}

} // namespace

void
defineParameters (py::module_& module)
{
  using Detector = PlaneDetectorParameters;
  using Merge = MergePlanesParameters;
  using Filter = PlaneFilter;
  using Matching = PlaneMatchingParameters;
  using Up = UpAxisParameters;
  using Edges = PlaneEdgeParameters;
  defineEnumerations (module);
  defineInner (module);
  parameters<Detector> (module, "evaluate")
      .def_readwrite ("up", &Detector::up_axis, "Vector")
      .def_readwrite ("angle_tolerance", &Detector::angle_tolerance, "float");
  parameters<Merge, Detector> (module, "merge_planes")
      .def_readwrite ("", &Merge::merging);
  defineDetectors (module);
  parameters<Filter> (module, "filter_planes")
      .def_readwrite ("orientation", &Filter::orientation, "Optional[Orientation]")
      .def_readwrite ("direction", &Filter::direction, "Optional[Vector]")
      .def_readwrite ("direction_tolerance", &Filter::direction_tolerance, "float")
      .def_readwrite ("slope", &Filter::slope, "Optional[Tuple[float, float]]")
      .def_readwrite ("up", &Filter::up_axis, "Vector")
      .def_readwrite ("min_points", &Filter::min_points, "int")
      .def_readwrite ("min_area", &Filter::min_area, "float")
      .def_readwrite ("min_width", &Filter::min_width, "float")
      .def_readwrite ("max_area", &Filter::max_area, "Optional[float]")
      .def_readwrite ("max_width", &Filter::max_width, "Optional[float]")
      .def_readwrite ("size", &Filter::size, "Optional[Tuple[float, float, float]]")
      .def_readwrite ("max_planes", &Filter::max_planes, "Optional[int]");
  parameters<Matching> (module, "match_planes")
      .def_readwrite ("rotation_error", &Matching::rotation_error, "float")
      .def_readwrite ("translation_error", &Matching::translation_error, "float")
      .def_readwrite ("min_overlap", &Matching::min_overlap, "float");
  parameters<Up> (module, "estimate_up_axis")
      .def_readwrite ("angle_tolerance", &Up::angle_tolerance, "float")
      .def_readwrite ("min_share", &Up::min_share, "float")
      .def_readwrite ("min_confidence", &Up::min_confidence, "float");
  parameters<Edges> (module, "find_plane_edges")
      .def_readwrite ("reach", &Edges::reach, "Optional[float]")
      .def_readwrite ("max_gap", &Edges::max_gap, "Optional[float]")
      .def_readwrite ("min_length", &Edges::min_length, "Optional[float]")
      .def_readwrite ("min_angle", &Edges::min_angle, "float");
}

} // namespace pcl_ops::python

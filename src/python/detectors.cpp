// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detectors.h"

#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

namespace pcl_ops::python {

namespace {

Fields<MergingParameters>
mergingFields ()
{
  using P = MergingParameters;
  return {field<P> ("enabled", &P::enabled),
          field<P> ("angle_threshold", &P::angle_threshold),
          field<P> ("distance_threshold", &P::distance_threshold),
          field<P> ("noise_factor", &P::noise_factor)};
}

template <typename P>
Fields<P>
orientationFields ()
{
  return {field<P> ("up", &P::up_axis),
          field<P> ("angle_tolerance", &P::angle_tolerance)};
}

/** \brief What all detectors have. */
template <typename P>
Fields<P>
sharedFields ()
{
  Fields<P> fields = orientationFields<P>();
  fields.push_back (field<P> ("distance_threshold", &P::distance_threshold));
  fields.push_back (field<P> ("seed", &P::seed));
  fields.push_back (field<P> ("threads", &P::threads));
  append (fields, "merging_", &P::merging, mergingFields());
  return fields;
}

Fields<SurfelParameters>
surfelFields ()
{
  using P = SurfelParameters;
  return {field<P> ("voxel_size", &P::voxel_size),
          field<P> ("resolutions", &P::resolutions),
          field<P> ("least_average_voxels", &P::least_average_voxels),
          field<P> ("noise_factor", &P::noise_factor),
          field<P> ("angle_threshold", &P::angle_threshold),
          field<P> ("sure_thickness", &P::sure_thickness),
          field<P> ("largest_thickness", &P::largest_thickness),
          field<P> ("absorption_noise_factor", &P::absorption_noise_factor),
          field<P> ("assignment_noise_factor", &P::assignment_noise_factor)};
}

Fields<OrientedPointSamplingParameters>
fieldsOf (const OrientedPointSamplingParameters&)
{
  using P = OrientedPointSamplingParameters;
  Fields<P> fields = {field<P> ("sampling", &P::sampling),
                      field<P> ("sampling_rate", &P::sampling_rate),
                      field<P> ("k", &P::k),
                      field<P> ("normal_sigma", &P::normal_sigma),
                      field<P> ("min_inliers", &P::min_inliers),
                      field<P> ("probability", &P::probability),
                      field<P> ("strategy", &P::strategy),
                      field<P> ("verification", &P::verification),
                      field<P> ("assignment_rule", &P::assignment_rule),
                      field<P> ("local_optimisation", &P::local_optimisation)};
  append (fields, "surfels_", &P::surfels, surfelFields());
  return fields;
}

Fields<LocalSamplingParameters>
localFields ()
{
  using P = LocalSamplingParameters;
  return {field<P> ("inner_radius", &P::inner_radius),
          field<P> ("outer_radius", &P::outer_radius),
          field<P> ("local_samples", &P::local_samples),
          field<P> ("min_inlier_fraction", &P::min_inlier_fraction),
          field<P> ("local_inliers", &P::inliers),
          field<P> ("max_inliers_per_point", &P::max_inliers_per_point),
          field<P> ("max_hypotheses_per_point", &P::max_hypotheses_per_point),
          field<P> ("max_visits_per_point", &P::max_visits_per_point)};
}

Fields<FastSamplingPlaneFilteringParameters>
fieldsOf (const FastSamplingPlaneFilteringParameters&)
{
  using P = FastSamplingPlaneFilteringParameters;
  Fields<P> fields;
  append (fields, "", &P::local, localFields());
  return fields;
}

Fields<KernelHoughTransformParameters>
fieldsOf (const KernelHoughTransformParameters&)
{
  using P = KernelHoughTransformParameters;
  using Clusters = OctreeClusterParameters;
  using Refit = PlaneRefitParameters;
  Fields<P> fields = {field<P> ("phi_num", &P::phi_num),
                      field<P> ("rho_num", &P::rho_num),
                      field<P> ("bounded", &P::bounded),
                      field<P> ("assignment", &P::assignment)};
  append (
      fields,
      "clusters_",
      &P::clusters,
      Fields<Clusters>{field<Clusters> ("min_samples", &Clusters::min_samples),
                       field<Clusters> ("first_level", &Clusters::first_level),
                       field<Clusters> ("s_alpha", &Clusters::s_alpha),
                       field<Clusters> ("s_beta", &Clusters::s_beta),
                       field<Clusters> ("deepest_level", &Clusters::deepest_level)});
  append (fields,
          "refit_",
          &P::refit,
          Fields<Refit>{field<Refit> ("enabled", &Refit::enabled),
                        field<Refit> ("min_share", &Refit::min_share)});
  return fields;
}

template <typename P>
Fields<P>
allFields (const P& preset)
{
  Fields<P> fields = fieldsOf (preset);
  const Fields<P> shared = sharedFields<P>();
  fields.insert (fields.end(), shared.begin(), shared.end());
  return fields;
}

/** \brief What is to be done with the parameters of a preset, whatever their type. */
template <typename Use>
auto
usePreset (const py::object& method, const py::object& preset, const Use& use)
{
  const bool is_paper = oneOf ("preset", {"default", "paper"}, preset) == 1;
  const auto useOf = [&] (const auto& by_default) {
    return use (is_paper ? std::decay_t<decltype (by_default)>::paper() : by_default);
  };
  switch (oneOf ("method", {"ops", "fspf", "kht"}, method)) {
  case 0:
    return useOf (OrientedPointSamplingParameters());
  case 1:
    return useOf (FastSamplingPlaneFilteringParameters());
  default:
    return useOf (KernelHoughTransformParameters());
  }
}

} // namespace

Detect
detectorOf (const py::object& method,
            const py::object& preset,
            const py::dict& parameters)
{
  return usePreset (method, preset, [&] (const auto& chosen) -> Detect {
    const auto decided =
        withGiven (allFields (chosen), chosen, parameters, [] (const auto& p) {
          return problemOf (p);
        });
    return [decided] (const DetectorInput& input) {
      return detectPlanes (input, decided);
    };
  });
}

py::dict
parametersOf (const py::object& method, const py::object& preset)
{
  return usePreset (method, preset, [] (const auto& chosen) {
    return toDict (allFields (chosen), chosen);
  });
}

PlaneDetectorParameters
orientationParameters (const py::dict& parameters)
{
  using P = PlaneDetectorParameters;
  return withGiven (orientationFields<P>(), P(), parameters, [] (const P& p) {
    return problemOf (p);
  });
}

MergingParameters
mergingParameters (const py::dict& parameters)
{
  return withGiven (mergingFields(),
                    MergingParameters(),
                    parameters,
                    [] (const MergingParameters& merging) {
                      PlaneDetectorParameters all;
                      all.merging = merging;
                      return problemOf (all);
                    });
}

} // namespace pcl_ops::python

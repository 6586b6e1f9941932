// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <functional>

namespace {

using OpsParameters = pcl_ops::OrientedPointSamplingParameters;
using FspfParameters = pcl_ops::FastSamplingPlaneFilteringParameters;
using KhtParameters = pcl_ops::KernelHoughTransformParameters;

/** \brief A change that makes parameters wrong, and what validate has to speak of. */
template <typename Parameters>
struct Mistake {
  std::string words;
  std::function<void (Parameters&)> make;
};

template <typename Parameters>
using Mistakes = std::vector<Mistake<Parameters>>;

/** \brief Adds numbers a field may not have: below zero, infinite, none at all, and
 * others. */
template <typename Parameters, typename Field>
void
addNumbers (const std::string& words,
            const Field& field,
            std::vector<double> others,
            Mistakes<Parameters>& mistakes)
{
  for (const double common : {-1.0, HUGE_VAL, std::nan ("")})
    others.push_back (common);
  for (const double bad : others)
    mistakes.push_back ({words, [=] (Parameters& p) { field (p) = bad; }});
}

/** \brief What is wrong for all detectors. */
template <typename Parameters>
Mistakes<Parameters>
mistakesOfAll ()
{
  using P = Parameters;
  Mistakes<P> mistakes{
      {"up axis", [] (P& p) { p.up_axis.setZero(); }},
      {"up axis", [] (P& p) { p.up_axis.y() = std::nanf (""); }},
      {"up axis", [] (P& p) { p.up_axis.y() = HUGE_VALF; }},
  };
  addNumbers<P> (
      "distance threshold",
      [](P & p) -> auto& { return p.distance_threshold; },
      {0.0},
      mistakes);
  addNumbers<P> (
      "angle tolerance",
      [](P & p) -> auto& { return p.angle_tolerance; },
      {91_deg},
      mistakes);
  addNumbers<P> (
      "merging angle",
      [](P & p) -> auto& { return p.merging.angle_threshold; },
      {91_deg},
      mistakes);
  addNumbers<P> (
      "merging distance",
      [](P & p) -> auto& { return p.merging.distance_threshold; },
      {},
      mistakes);
  addNumbers<P> (
      "merging noise",
      [](P & p) -> auto& { return p.merging.noise_factor; },
      {},
      mistakes);
  return mistakes;
}

template <typename Parameters>
void
expectRefused (const Mistakes<Parameters>& mistakes, const Parameters& good)
{
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    Parameters parameters = good;
    mistakes[i].make (parameters);
    const std::string problem = validate (parameters);
    EXPECT_NE (problem.find (mistakes[i].words), std::string::npos)
        << "'" << problem << "' should speak of " << mistakes[i].words << " (" << i
        << ")";
  }
}

template <typename Parameters>
void
expectAccepted (const std::vector<std::function<void (Parameters&)>>& changes)
{
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Parameters parameters;
    changes[i](parameters);
    EXPECT_EQ (validate (parameters), "") << i;
  }
}

Mistakes<OpsParameters>
mistakesOfOps ()
{
  using P = OpsParameters;
  Mistakes<P> mistakes{{"k must be 2", [] (P& p) { p.k = 1; }},
                       {"k must be 2", [] (P& p) { p.k = -5; }}};
  addNumbers<P> (
      "sampling rate",
      [](P & p) -> auto& { return p.sampling_rate; },
      {0.0, 1.01},
      mistakes);
  addNumbers<P> (
      "sigma",
      [](P & p) -> auto& { return p.paper_only.normal_sigma; },
      {0.0},
      mistakes);
  addNumbers<P> (
      "probability",
      [](P & p) -> auto& { return p.paper_only.probability; },
      {0.0, 1.0},
      mistakes);
  return mistakes;
}

Mistakes<OpsParameters>
mistakesOfSurfels ()
{
  using P = OpsParameters;
  Mistakes<P> mistakes{{"resolutions", [] (P& p) { p.surfels.resolutions = 0; }},
                       {"resolutions", [] (P& p) { p.surfels.resolutions = 11; }}};
  const auto add = [&mistakes] (
                       const std::string& words,
                       auto pcl_ops::OrientedPointSamplingParameters::Surfels::*field,
                       const std::vector<double>& others = {}) {
    addNumbers<P> (
        words, [field](P & p) -> auto& { return p.surfels.*field; }, others, mistakes);
  };
  using Surfels = pcl_ops::OrientedPointSamplingParameters::Surfels;
  add ("voxel size", &Surfels::voxel_size, {0.0, 1e-40, 1e40});
  add ("least average voxels", &Surfels::min_average_voxels);
  add ("noise factor of surfels", &Surfels::noise_factor);
  add ("angle threshold of surfels", &Surfels::angle_threshold, {91_deg});
  add ("thickness of surfels", &Surfels::sure_thickness);
  add ("thickness of surfels", &Surfels::max_thickness);
  add ("noise factor of absorption", &Surfels::absorption_noise_factor);
  add ("noise factor of assignment", &Surfels::assignment_noise_factor);
  return mistakes;
}

Mistakes<FspfParameters>
mistakesOfFspf ()
{
  using P = FspfParameters;
  Mistakes<P> mistakes{
      {"outer radius", [] (P& p) { p.local.inner_radius = 0.3; }},
      {"local samples", [] (P& p) { p.local.local_samples = 2; }},
      {"distance threshold", [] (P& p) { p.distance_threshold.reset(); }}};
  using Local = pcl_ops::FastSamplingPlaneFilteringParameters::Local;
  const auto add = [&mistakes] (const std::string& words,
                                double Local::*field,
                                const std::vector<double>& others) {
    addNumbers<P> (
        words, [field] (P& p) -> double& { return p.local.*field; }, others, mistakes);
  };
  add ("inner radius", &Local::inner_radius, {0.0, 1e-320});
  add ("outer radius", &Local::outer_radius, {0.0, 1e-320});
  add ("inlier fraction", &Local::min_inlier_fraction, {1.0});
  add ("inliers per point", &Local::max_inliers_per_point, {0.0});
  add ("hypotheses per point", &Local::max_hypotheses_per_point, {0.0});
  add ("visits per point", &Local::max_visits_per_point, {0.0});
  return mistakes;
}

const Mistakes<KhtParameters> mistakes_of_kht{
    {"phi_num", [] (KhtParameters& p) { p.phi_num = 1; }},
    {"phi_num", [] (KhtParameters& p) { p.phi_num = 1001; }},
    {"rho_num", [] (KhtParameters& p) { p.rho_num = 1; }},
    {"rho_num", [] (KhtParameters& p) { p.rho_num = 10001; }},
    {"three samples", [] (KhtParameters& p) { p.clusters.min_samples = 2; }},
    {"s_level", [] (KhtParameters& p) { p.clusters.first_level = -1; }},
    {"s_level", [] (KhtParameters& p) { p.clusters.max_level = 2; }},
    {"deepest level", [] (KhtParameters& p) { p.clusters.max_level = 61; }},
    {"s_alpha", [] (KhtParameters& p) { p.clusters.s_alpha = 0.0; }},
    {"s_alpha", [] (KhtParameters& p) { p.clusters.s_alpha = std::nan (""); }},
    {"s_beta", [] (KhtParameters& p) { p.clusters.s_beta = 0.0; }},
    {"s_beta", [] (KhtParameters& p) { p.clusters.s_beta = std::nan (""); }},
    {"smallest share", [] (KhtParameters& p) { p.refit.min_share = -0.1; }},
    {"smallest share", [] (KhtParameters& p) { p.refit.min_share = 2.0; }},
    {"smallest share", [] (KhtParameters& p) { p.refit.min_share = std::nan (""); }},
    {"distance threshold", [] (KhtParameters& p) { p.distance_threshold.reset(); }}};

} // namespace

TEST (ProblemOf, GoodParametersIsEmpty)
{
  EXPECT_EQ (validate (OpsParameters()), "");
  EXPECT_EQ (validate (OpsParameters::paper()), "");
  EXPECT_EQ (validate (FspfParameters()), "");
  EXPECT_EQ (validate (FspfParameters::paper()), "");
  EXPECT_EQ (validate (KhtParameters()), "");
  EXPECT_EQ (validate (KhtParameters::paper()), "");
}

TEST (ProblemOf, ParametersOfOpsNamesTheWrongOne)
{
  for (const OpsParameters& good : {OpsParameters(), OpsParameters::paper()}) {
    expectRefused (mistakesOfAll<OpsParameters>(), good);
    expectRefused (mistakesOfOps(), good);
    expectRefused (mistakesOfSurfels(), good);
  }
}

TEST (ProblemOf, ParametersOfFspfNamesTheWrongOne)
{
  expectRefused (mistakesOfAll<FspfParameters>(), FspfParameters());
  expectRefused (mistakesOfFspf(), FspfParameters());
}

TEST (ProblemOf, ParametersOfKhtNamesTheWrongOne)
{
  expectRefused (mistakesOfAll<KhtParameters>(), KhtParameters());
  expectRefused (mistakes_of_kht, KhtParameters());
}

TEST (ProblemOf, DrawnPointsWithoutADistanceThresholdNamesIt)
{
  OpsParameters parameters = OpsParameters::paper();
  parameters.distance_threshold.reset();
  EXPECT_EQ (validate (parameters), "the distance threshold must be a length above 0");
}

TEST (ProblemOf, ValuesAtTheEndsOfTheirRangesIsEmpty)
{
  expectAccepted<OpsParameters> ({[] (auto& p) { p.sampling_rate = 1.0; },
                                  [] (auto& p) { p.k = 2; },
                                  [] (auto& p) { p.min_inliers = 0; },
                                  [] (auto& p) { p.angle_tolerance = 0.0; },
                                  [] (auto& p) { p.angle_tolerance = 90_deg; },
                                  [] (auto& p) { p.merging.distance_threshold = 0.0; },
                                  [] (auto& p) { p.merging.noise_factor = 0.0; },
                                  [] (auto& p) { p.surfels.resolutions = 1; },
                                  [] (auto& p) { p.surfels.resolutions = 10; },
                                  [] (auto& p) { p.surfels.voxel_size = 1e-6; },
                                  [] (auto& p) { p.surfels.sure_thickness = 0.0; }});
}

TEST (ProblemOf, AnUpAxisOfAnyLengthIsEmpty)
{
  for (const float length : {1e-30f, 1e30f})
    expectAccepted<OpsParameters> ({[length] (auto& p) { p.up_axis *= length; }});
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

namespace {

using OpsParameters = pcl_ops::OrientedPointSamplingParameters;
using FspfParameters = pcl_ops::FastSamplingPlaneFilteringParameters;
using KhtParameters = pcl_ops::KernelHoughTransformParameters;

const double nan_value = std::nan ("");

/** \brief What a parameter may be. */
template <typename Parameters>
struct Range {
  /** \brief What problemOf has to speak of. */
  const char* words;
  void (*set) (Parameters&, double);
  std::vector<double> wrong;
  std::vector<double> right = {};
};

template <typename Parameters>
using Ranges = std::vector<Range<Parameters>>;

/** \brief Below zero, infinite, none at all, and others. */
std::vector<double>
notPositive (std::vector<double> others = {})
{
  others.insert (others.end(), {-1.0, HUGE_VAL, nan_value});
  return others;
}

template <typename P>
Ranges<P>
rangesOfAll ()
{
  return {{"up axis",
           [] (P& p, double v) { p.up_axis *= static_cast<float> (v); },
           {0.0, nan_value, HUGE_VAL},
           {1e-30, 1e30}},
          {"distance threshold",
           [] (P& p, double v) { p.distance_threshold = v; },
           notPositive ({0.0})},
          {"angle tolerance",
           [] (P& p, double v) { p.angle_tolerance = v; },
           notPositive ({91_deg}),
           {0.0, 90_deg}},
          {"merging angle",
           [] (P& p, double v) { p.merging.angle_threshold = v; },
           notPositive ({91_deg})},
          {"merging distance",
           [] (P& p, double v) { p.merging.distance_threshold = v; },
           notPositive(),
           {0.0}},
          {"merging noise",
           [] (P& p, double v) { p.merging.noise_factor = v; },
           notPositive(),
           {0.0}}};
}

const Ranges<OpsParameters> ranges_of_ops = {
    {"k must be 2",
     [] (OpsParameters& p, double v) { p.k = static_cast<int> (v); },
     {1, -5},
     {2}},
    {"",
     [] (OpsParameters& p, double v) { p.min_inliers = static_cast<unsigned> (v); },
     {},
     {0}},
    {"sampling rate",
     [] (OpsParameters& p, double v) { p.sampling_rate = v; },
     notPositive ({0.0, 1.01}),
     {1.0}},
    {"sigma",
     [] (OpsParameters& p, double v) { p.normal_sigma = v; },
     notPositive ({0.0})},
    {"probability",
     [] (OpsParameters& p, double v) { p.probability = v; },
     notPositive ({0.0, 1.0})},
    {"resolutions",
     [] (OpsParameters& p, double v) { p.surfels.resolutions = static_cast<int> (v); },
     {0, 11},
     {1, 10}},
    {"voxel size",
     [] (OpsParameters& p, double v) { p.surfels.voxel_size = v; },
     notPositive ({0.0, 1e-40, 1e40}),
     {1e-6}},
    {"least average voxels",
     [] (OpsParameters& p, double v) { p.surfels.least_average_voxels = v; },
     notPositive()},
    {"noise factor of surfels",
     [] (OpsParameters& p, double v) { p.surfels.noise_factor = v; },
     notPositive()},
    {"angle threshold of surfels",
     [] (OpsParameters& p, double v) { p.surfels.angle_threshold = v; },
     notPositive ({91_deg})},
    {"thickness of surfels",
     [] (OpsParameters& p, double v) { p.surfels.sure_thickness = v; },
     notPositive(),
     {0.0}},
    {"thickness of surfels",
     [] (OpsParameters& p, double v) { p.surfels.largest_thickness = v; },
     notPositive()},
    {"noise factor of absorption",
     [] (OpsParameters& p, double v) { p.surfels.absorption_noise_factor = v; },
     notPositive()},
    {"noise factor of assignment",
     [] (OpsParameters& p, double v) { p.surfels.assignment_noise_factor = v; },
     notPositive()}};

const Ranges<FspfParameters> ranges_of_fspf = {
    {"outer radius",
     [] (FspfParameters& p, double v) { p.local.inner_radius = v; },
     {0.3}},
    {"inner radius",
     [] (FspfParameters& p, double v) { p.local.inner_radius = v; },
     notPositive ({0.0, 1e-320})},
    {"outer radius",
     [] (FspfParameters& p, double v) { p.local.outer_radius = v; },
     notPositive ({0.0, 1e-320})},
    {"local samples",
     [] (FspfParameters& p, double v) {
       p.local.local_samples = static_cast<unsigned> (v);
     },
     {2}},
    {"distance threshold",
     [] (FspfParameters& p, double) { p.distance_threshold.reset(); },
     {nan_value}},
    {"inlier fraction",
     [] (FspfParameters& p, double v) { p.local.min_inlier_fraction = v; },
     notPositive ({1.0})},
    {"inliers per point",
     [] (FspfParameters& p, double v) { p.local.max_inliers_per_point = v; },
     notPositive ({0.0})},
    {"hypotheses per point",
     [] (FspfParameters& p, double v) { p.local.max_hypotheses_per_point = v; },
     notPositive ({0.0})},
    {"visits per point",
     [] (FspfParameters& p, double v) { p.local.max_visits_per_point = v; },
     notPositive ({0.0})}};

const Ranges<KhtParameters> ranges_of_kht = {
    {"phi_num",
     [] (KhtParameters& p, double v) { p.phi_num = static_cast<int> (v); },
     {1, 1001},
     {2, 1000}},
    {"rho_num",
     [] (KhtParameters& p, double v) { p.rho_num = static_cast<int> (v); },
     {1, 10001},
     {2, 10000}},
    {"three samples",
     [] (KhtParameters& p, double v) {
       p.clusters.min_samples = static_cast<unsigned> (v);
     },
     {2},
     {3}},
    {"s_level",
     [] (KhtParameters& p, double v) { p.clusters.first_level = static_cast<int> (v); },
     {-1}},
    {"s_level",
     [] (KhtParameters& p, double v) {
       p.clusters.deepest_level = static_cast<int> (v);
     },
     {2},
     {3, 60}},
    {"deepest level",
     [] (KhtParameters& p, double v) {
       p.clusters.deepest_level = static_cast<int> (v);
     },
     {61}},
    {"s_alpha",
     [] (KhtParameters& p, double v) { p.clusters.s_alpha = v; },
     {0.0, nan_value}},
    {"s_beta",
     [] (KhtParameters& p, double v) { p.clusters.s_beta = v; },
     {0.0, nan_value}},
    {"smallest share",
     [] (KhtParameters& p, double v) { p.refit.min_share = v; },
     {-0.1, 2.0, nan_value}},
    {"distance threshold",
     [] (KhtParameters& p, double) { p.distance_threshold.reset(); },
     {nan_value}}};

template <typename Parameters>
void
expectRanges (const Ranges<Parameters>& ranges, const Parameters& good)
{
  EXPECT_EQ (problemOf (good), "");
  for (const Range<Parameters>& range : ranges) {
    for (const double wrong : range.wrong) {
      Parameters parameters = good;
      range.set (parameters, wrong);
      const std::string problem = problemOf (parameters);
      EXPECT_NE (problem.find (range.words), std::string::npos)
          << "'" << problem << "' should speak of " << range.words << " at " << wrong;
      EXPECT_NE (problem, "") << range.words << " at " << wrong;
    }
    for (const double right : range.right) {
      Parameters parameters = good;
      range.set (parameters, right);
      EXPECT_EQ (problemOf (parameters), "") << range.words << " at " << right;
    }
  }
}

} // namespace

TEST (ProblemOf, ParametersOfOpsNamesTheWrongOne)
{
  for (const OpsParameters& good : {OpsParameters(), OpsParameters::paper()}) {
    expectRanges (rangesOfAll<OpsParameters>(), good);
    expectRanges (ranges_of_ops, good);
  }
}

TEST (ProblemOf, ParametersOfFspfNamesTheWrongOne)
{
  for (const FspfParameters& good : {FspfParameters(), FspfParameters::paper()})
    expectRanges (rangesOfAll<FspfParameters>(), good);
  expectRanges (ranges_of_fspf, FspfParameters());
}

TEST (ProblemOf, ParametersOfKhtNamesTheWrongOne)
{
  for (const KhtParameters& good : {KhtParameters(), KhtParameters::paper()})
    expectRanges (rangesOfAll<KhtParameters>(), good);
  expectRanges (ranges_of_kht, KhtParameters());
}

TEST (ProblemOf, DrawnPointsWithoutADistanceThresholdNamesIt)
{
  OpsParameters parameters = OpsParameters::paper();
  parameters.distance_threshold.reset();
  EXPECT_EQ (problemOf (parameters), "the distance threshold must be a length above 0");
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_filter.h>
#include <pcl_ops/plane_matching.h>
#include <pcl_ops/up_axis.h>

#include <functional>

namespace {

using OpsParameters = pcl_ops::OrientedPointSamplingParameters;
using FspfParameters = pcl_ops::FastSamplingPlaneFilteringParameters;
using KhtParameters = pcl_ops::KernelHoughTransformParameters;

const double nan_value = std::nan ("");

/** \brief What a parameter may be. */
template <typename Parameters>
struct Range {
  /** \brief What validate has to speak of. */
  const char* words;
  std::function<void (Parameters&, double)> set;
  std::vector<double> wrong;
  std::vector<double> right = {};
};

template <typename Parameters>
using Ranges = std::vector<Range<Parameters>>;

/** \brief Sets a member. */
template <typename Owner, typename Value>
auto
of (Value Owner::*member)
{
  return
      [=] (Owner& owner, double value) { owner.*member = static_cast<Value> (value); };
}

/** \brief Sets a member of a member. */
template <typename Owner, typename Group, typename Value>
auto
of (Group Owner::*group, Value Group::*member)
{
  return [=] (Owner& owner, double value) {
    owner.*group.*member = static_cast<Value> (value);
  };
}

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
  using All = pcl_ops::PlaneDetectorParameters;
  using Merging = pcl_ops::MergingParameters;
  const auto up = [] (P& p, double v) { p.up_axis *= static_cast<float> (v); };
  return {
      {"up axis", up, {0.0, nan_value, HUGE_VAL}, {1e-30, 1e30}},
      {"distance threshold", of (&All::distance_threshold), notPositive ({0.0})},
      {"angle tolerance", of (&All::angle_tolerance), notPositive ({2.0}), {0.0, 1.5}},
      {"merging angle",
       of (&All::merging, &Merging::angle_threshold),
       notPositive ({2.0})},
      {"merging distance",
       of (&All::merging, &Merging::distance_threshold),
       notPositive(),
       {0.0}},
      {"merging noise",
       of (&All::merging, &Merging::noise_factor),
       notPositive(),
       {0.0}}};
}

Ranges<OpsParameters>
rangesOfOps ()
{
  using P = OpsParameters;
  using S = P::Surfels;
  constexpr auto surfels = &P::surfels;
  return {{"k must be 2", of (&P::k), {1, -5}, {2}},
          {"", of (&P::min_inliers), {}, {0}},
          {"sampling rate", of (&P::sampling_rate), notPositive ({0.0, 1.01}), {1.0}},
          {"sigma",
           of (&P::paper_only, &pcl_ops::PaperParameters::normal_sigma),
           notPositive ({0.0})},
          {"probability",
           of (&P::paper_only, &pcl_ops::PaperParameters::probability),
           notPositive ({0.0, 1.0})},
          {"resolutions", of (surfels, &S::resolutions), {0, 11}, {1, 10}},
          {"voxel size",
           of (surfels, &S::voxel_size),
           notPositive ({0.0, 1e-40, 1e40}),
           {1e-6}},
          {"least average voxels", of (surfels, &S::min_average_voxels), notPositive()},
          {"noise factor of surfels", of (surfels, &S::noise_factor), notPositive()},
          {"angle threshold", of (surfels, &S::angle_threshold), notPositive ({2.0})},
          {"thickness", of (surfels, &S::sure_thickness), notPositive(), {0.0}},
          {"thickness", of (surfels, &S::max_thickness), notPositive()},
          {"of absorption", of (surfels, &S::absorption_noise_factor), notPositive()},
          {"of assignment", of (surfels, &S::assignment_noise_factor), notPositive()}};
}

Ranges<FspfParameters>
rangesOfFspf ()
{
  using L = FspfParameters::Local;
  constexpr auto local = &FspfParameters::local;
  const auto without = [] (auto& p, double) { p.distance_threshold.reset(); };
  return {
      {"outer radius", of (local, &L::inner_radius), {0.3}},
      {"inner radius", of (local, &L::inner_radius), notPositive ({0.0, 1e-320})},
      {"outer radius", of (local, &L::outer_radius), notPositive ({0.0, 1e-320})},
      {"local samples", of (local, &L::local_samples), {2}, {3}},
      {"distance threshold", without, {nan_value}},
      {"inlier fraction", of (local, &L::min_inlier_fraction), notPositive ({1.0})},
      {"inliers per point", of (local, &L::max_inliers_per_point), notPositive ({0.0})},
      {"hypotheses", of (local, &L::max_hypotheses_per_point), notPositive ({0.0})},
      {"visits", of (local, &L::max_visits_per_point), notPositive ({0.0})}};
}

Ranges<KhtParameters>
rangesOfKht ()
{
  using C = KhtParameters::Clusters;
  constexpr auto clusters = &KhtParameters::clusters;
  const auto without = [] (auto& p, double) { p.distance_threshold.reset(); };
  return {{"phi_num", of (&KhtParameters::phi_num), {1, 1001}, {2, 1000}},
          {"rho_num", of (&KhtParameters::rho_num), {1, 10001}, {2, 10000}},
          {"three samples", of (clusters, &C::min_samples), {2}, {3}},
          {"s_level", of (clusters, &C::first_level), {-1}},
          {"s_level", of (clusters, &C::max_level), {2}, {5, 60}},
          {"deepest level", of (clusters, &C::max_level), {61}},
          {"s_alpha", of (clusters, &C::s_alpha), {0.0, nan_value}},
          {"s_beta", of (clusters, &C::s_beta), {0.0, nan_value}},
          {"smallest share",
           of (&KhtParameters::refit, &KhtParameters::Refit::min_share),
           {-0.1, 2.0, nan_value}},
          {"distance threshold", without, {nan_value}}};
}

Ranges<pcl_ops::PlaneFilter>
rangesOfFilter ()
{
  using F = pcl_ops::PlaneFilter;
  const auto direction = [] (F& f, double v) { f.direction = {0.0, 0.0, v}; };
  const auto up = [] (F& f, double v) { f.up_axis *= v; };
  const auto slope = [] (F& f, double v) { f.slope = {0.1, v}; };
  const auto size = [] (F& f, double v) { f.size = {1.0, 2.0, v}; };
  return {
      {"direction must", direction, {0.0, nan_value, HUGE_VAL}, {-7.0}},
      {"direction tolerance", of (&F::direction_tolerance), notPositive ({2.0}), {0.0}},
      {"up axis", up, {0.0, nan_value}, {7.0}},
      {"slope", slope, notPositive ({0.05, 2.0}), {0.1, 1.5}},
      {"smallest area", of (&F::min_area), notPositive(), {0.0}},
      {"smallest width", of (&F::min_width), notPositive(), {0.0}},
      {"largest area", of (&F::max_area), notPositive ({0.9}), {1.0}},
      {"largest width", of (&F::max_width), notPositive ({0.9}), {1.0}},
      {"size", size, notPositive(), {0.0}}};
}

Ranges<pcl_ops::PlaneMatchingParameters>
rangesOfMatching ()
{
  using P = pcl_ops::PlaneMatchingParameters;
  return {{"rotation", of (&P::rotation_error), notPositive ({2.0}), {0.0, 1.5}},
          {"translation", of (&P::translation_error), notPositive(), {0.0}},
          {"overlap", of (&P::min_overlap), notPositive ({1.1}), {0.0, 1.0}}};
}

Ranges<pcl_ops::PlaneEdgeParameters>
rangesOfEdges ()
{
  using P = pcl_ops::PlaneEdgeParameters;
  return {{"reach", of (&P::reach), notPositive(), {0.0}},
          {"gap", of (&P::max_gap), notPositive(), {0.0}},
          {"smallest length", of (&P::min_length), notPositive(), {0.0}},
          {"smallest angle", of (&P::min_angle), notPositive ({0.0, 2.0}), {1.5}}};
}

Ranges<pcl_ops::UpAxisParameters>
rangesOfUpAxis ()
{
  using P = pcl_ops::UpAxisParameters;
  return {{"tolerance", of (&P::angle_tolerance), notPositive ({0.0, 7.0}), {1.5}},
          {"share", of (&P::min_share), notPositive ({2.0}), {0.0, 1.0}},
          {"confidence", of (&P::min_confidence), notPositive ({2.0}), {0.0, 1.0}}};
}

template <typename Parameters>
void
expectRanges (const Ranges<Parameters>& ranges, const Parameters& good)
{
  EXPECT_EQ (validate (good), "");
  for (const Range<Parameters>& range : ranges) {
    for (const double wrong : range.wrong) {
      Parameters parameters = good;
      range.set (parameters, wrong);
      const std::string problem = validate (parameters);
      EXPECT_NE (problem.find (range.words), std::string::npos)
          << "'" << problem << "' should speak of " << range.words << " at " << wrong;
      EXPECT_NE (problem, "") << range.words << " at " << wrong;
    }
    for (const double right : range.right) {
      Parameters parameters = good;
      range.set (parameters, right);
      EXPECT_EQ (validate (parameters), "") << range.words << " at " << right;
    }
  }
}

} // namespace

TEST (ProblemOf, ParametersOfOpsNamesTheWrongOne)
{
  for (const OpsParameters& good : {OpsParameters(), OpsParameters::paper()}) {
    expectRanges (rangesOfAll<OpsParameters>(), good);
    expectRanges (rangesOfOps(), good);
  }
}

TEST (ProblemOf, ParametersOfFspfNamesTheWrongOne)
{
  for (const FspfParameters& good : {FspfParameters(), FspfParameters::paper()})
    expectRanges (rangesOfAll<FspfParameters>(), good);
  expectRanges (rangesOfFspf(), FspfParameters());
}

TEST (ProblemOf, ParametersOfKhtNamesTheWrongOne)
{
  for (const KhtParameters& good : {KhtParameters(), KhtParameters::paper()})
    expectRanges (rangesOfAll<KhtParameters>(), good);
  expectRanges (rangesOfKht(), KhtParameters());
}

TEST (ProblemOf, DrawnPointsWithoutADistanceThresholdNamesIt)
{
  OpsParameters parameters = OpsParameters::paper();
  parameters.distance_threshold.reset();
  EXPECT_EQ (validate (parameters), "the distance threshold must be a length above 0");
}

TEST (ProblemOf, WhatIsDoneWithPlanesNamesTheWrongOne)
{
  pcl_ops::PlaneFilter filter;
  filter.min_area = filter.min_width = 1.0;
  expectRanges (rangesOfFilter(), filter);
  expectRanges (rangesOfMatching(), pcl_ops::PlaneMatchingParameters());
  expectRanges (rangesOfEdges(), pcl_ops::PlaneEdgeParameters());
  expectRanges (rangesOfUpAxis(), pcl_ops::UpAxisParameters());
}

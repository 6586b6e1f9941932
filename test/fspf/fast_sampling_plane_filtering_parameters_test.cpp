// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scene.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>

#include <functional>

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

using Fspf = FastSamplingPlaneFiltering<pcl::PointXYZ>;
using Parameters = FastSamplingPlaneFilteringParameters;

std::string
problemAfter (const std::function<void (Parameters&)>& change)
{
  Parameters parameters;
  change (parameters);
  return problemOf (parameters);
}

} // namespace

TEST (PaperPreset, IsTheRowOfTableFour)
{
  const auto paper = Parameters::paper();
  EXPECT_EQ (paper.local.inner_radius, 0.07) << "Table IV";
  EXPECT_EQ (paper.local.outer_radius, 0.14) << "Table IV";
  EXPECT_EQ (paper.local.local_samples, 80u) << "section IV-A";
  EXPECT_EQ (paper.local.min_inlier_fraction, 0.8) << "section IV-A";
  EXPECT_EQ (paper.distance_threshold, 0.05) << "section IV-A";
  EXPECT_DOUBLE_EQ (paper.angle_tolerance, 7_deg) << "section IV-A";
}

TEST (PaperPreset, DecidesWhatThePaperLeavesOpen)
{
  const auto paper = Parameters::paper();
  EXPECT_EQ (paper.local.inliers, LocalInliers::Sphere) << "section III-B, the text";
  EXPECT_EQ (paper.local.max_inliers_per_point, 2.0) << "N_max";
  EXPECT_EQ (paper.local.max_hypotheses_per_point, 1.0) << "K_max";
}

TEST (Setters, AreReadByTheirGetters)
{
  Fspf fspf;
  fspf.setInnerRadius (0.11);
  fspf.setOuterRadius (0.33);
  fspf.setLocalSamples (55);
  fspf.setMinInlierFraction (0.66);
  fspf.setLocalInliers (LocalInliers::Samples);
  fspf.setMaxInliersPerPoint (4.4);
  fspf.setMaxHypothesesPerPoint (0.5);
  EXPECT_EQ (fspf.getInnerRadius(), 0.11);
  EXPECT_EQ (fspf.getOuterRadius(), 0.33);
  EXPECT_EQ (fspf.getLocalSamples(), 55u);
  EXPECT_EQ (fspf.getMinInlierFraction(), 0.66);
  EXPECT_EQ (fspf.getLocalInliers(), LocalInliers::Samples);
  EXPECT_EQ (fspf.getMaxInliersPerPoint(), 4.4);
  EXPECT_EQ (fspf.getMaxHypothesesPerPoint(), 0.5);
}

TEST (Setters, WriteIntoTheParameters)
{
  Fspf fspf;
  fspf.setParameters (Parameters::paper());
  fspf.setOuterRadius (0.33);
  EXPECT_EQ (fspf.getParameters().local.outer_radius, 0.33);
  EXPECT_EQ (fspf.getParameters().local.inner_radius, 0.07);
}

TEST (ProblemOf, DefaultAndPaperParametersIsNone)
{
  EXPECT_EQ (problemOf (Parameters()), "");
  EXPECT_EQ (problemOf (Parameters::paper()), "");
}

TEST (ProblemOf, LengthsAndLimitsNamesThem)
{
  for (const double bad : {0.0, -1.0, std::nan (""), HUGE_VAL, 1e-320}) {
    EXPECT_NE (problemAfter ([=] (auto& p) { p.local.inner_radius = bad; }), "") << bad;
    EXPECT_NE (problemAfter ([=] (auto& p) { p.local.outer_radius = bad; }), "") << bad;
    EXPECT_NE (problemAfter ([=] (auto& p) { p.local.max_inliers_per_point = bad; }),
               "");
    EXPECT_NE (problemAfter ([=] (auto& p) { p.local.max_hypotheses_per_point = bad; }),
               "");
  }
}

TEST (ProblemOf, EndsOfRangesNamesThem)
{
  EXPECT_EQ (problemAfter ([] (auto& p) { p.local.inner_radius = 0.3; }),
             "the outer radius must be a length, and not below the inner radius");
  EXPECT_NE (problemAfter ([] (auto& p) { p.local.local_samples = 2; }), "");
  EXPECT_NE (problemAfter ([] (auto& p) { p.local.min_inlier_fraction = 1.0; }), "");
  EXPECT_NE (problemAfter ([] (auto& p) { p.local.min_inlier_fraction = -0.1; }), "");
  EXPECT_NE (problemAfter ([] (auto& p) { p.distance_threshold = 0.0; }), "");
}

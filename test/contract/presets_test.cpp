// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/up_axis.h>

using namespace pcl_ops;

// Every field of every preset: a default that changes changes results.

namespace {

/** \brief What no preset changes. */
void
expectCommon (const PlaneDetectorParameters& preset)
{
  EXPECT_EQ (preset.up_axis, Eigen::Vector3f::UnitZ());
  EXPECT_DOUBLE_EQ (preset.angle_tolerance, 7_deg);
  EXPECT_EQ (preset.seed, 42u);
  EXPECT_EQ (preset.threads, 1u);
  EXPECT_DOUBLE_EQ (preset.merging.angle_threshold, 7_deg);
  EXPECT_EQ (preset.merging.distance_threshold, std::nullopt);
  EXPECT_EQ (preset.merging.noise_factor, std::nullopt);
}

void
expectDefaults (const OrientedPointSamplingParameters::Surfels& surfels)
{
  EXPECT_EQ (surfels.voxel_size, std::nullopt);
  EXPECT_EQ (surfels.resolutions, 3);
  EXPECT_EQ (surfels.min_average_voxels, 6.0);
  EXPECT_EQ (surfels.noise_factor, 2.0);
  EXPECT_DOUBLE_EQ (surfels.angle_threshold, 30_deg);
  EXPECT_EQ (surfels.sure_thickness, 0.24);
  EXPECT_EQ (surfels.max_thickness, 0.3);
  EXPECT_EQ (surfels.absorption_noise_factor, 3.5);
  EXPECT_EQ (surfels.assignment_noise_factor, 5.0);
}

void
expectSame (const OrientedPointSamplingParameters& preset)
{
  expectCommon (preset);
  expectDefaults (preset.surfels);
  EXPECT_TRUE (preset.merging.enabled);
  EXPECT_EQ (preset.sampling_rate, 0.03);
  EXPECT_EQ (preset.k, 30);
  EXPECT_EQ (preset.paper_only.normal_sigma, std::nullopt);
  EXPECT_EQ (preset.min_inliers, 20u);
  EXPECT_EQ (preset.paper_only.probability, 0.99);
  EXPECT_EQ (preset.paper_only.verification, PaperParameters::Verification::Samples);
  EXPECT_EQ (preset.paper_only.assignment_rule, AssignmentRule::First);
}

void
expectSame (const FastSamplingPlaneFilteringParameters& preset)
{
  expectCommon (preset);
  EXPECT_EQ (preset.distance_threshold, 0.05);
  EXPECT_TRUE (preset.merging.enabled);
  EXPECT_EQ (preset.local.local_samples, 80u);
  EXPECT_EQ (preset.local.min_inlier_fraction, 0.8);
  EXPECT_EQ (preset.local.inliers,
             FastSamplingPlaneFilteringParameters::Local::Inliers::Sphere);
  EXPECT_EQ (preset.local.max_inliers_per_point, 2.0);
  EXPECT_EQ (preset.local.max_hypotheses_per_point, 1.0);
  EXPECT_EQ (preset.local.max_visits_per_point, 100.0);
}

void
expectSame (const KernelHoughTransformParameters& preset)
{
  expectCommon (preset);
  EXPECT_EQ (preset.distance_threshold, 0.05);
  EXPECT_EQ (preset.clusters.min_samples, 30u);
  EXPECT_EQ (preset.clusters.s_beta, 6.0);
  EXPECT_EQ (preset.clusters.max_level, 20);
  EXPECT_EQ (preset.refit.min_share, 0.001);
}

} // namespace

TEST (OpsPreset, DefaultIsTheRecommendedOneAndPaperItsBestRow)
{
  const OrientedPointSamplingParameters preset;
  expectSame (preset);
  EXPECT_EQ (preset.distance_threshold, std::nullopt);
  EXPECT_EQ (preset.sampling, Sampling::Surfels);
  EXPECT_EQ (preset.paper_only.strategy, PaperParameters::Strategy::DetectThenDivide);
  EXPECT_TRUE (preset.paper_only.local_optimization);
  const auto paper = OrientedPointSamplingParameters::paper();
  expectSame (paper);
  EXPECT_EQ (paper.distance_threshold, 0.05);
  EXPECT_EQ (paper.sampling, Sampling::Points);
  EXPECT_EQ (paper.paper_only.strategy, PaperParameters::Strategy::DivideThenDetect);
  EXPECT_FALSE (paper.paper_only.local_optimization);
}

TEST (FspfPreset, HasTheRadiiOfTableOneAndAsPaperThoseOfTableFour)
{
  const FastSamplingPlaneFilteringParameters preset;
  expectSame (preset);
  EXPECT_EQ (preset.local.inner_radius, 0.1);
  EXPECT_EQ (preset.local.outer_radius, 0.2);
  const auto paper = FastSamplingPlaneFilteringParameters::paper();
  expectSame (paper);
  EXPECT_EQ (paper.local.inner_radius, 0.07);
  EXPECT_EQ (paper.local.outer_radius, 0.14);
}

TEST (KhtPreset, DefaultIsTheRecommendedOneAndPaperTheMethodAsPublished)
{
  const KernelHoughTransformParameters preset;
  expectSame (preset);
  EXPECT_TRUE (preset.merging.enabled);
  EXPECT_EQ (preset.phi_num, 30);
  EXPECT_EQ (preset.rho_num, 300);
  EXPECT_EQ (preset.clusters.first_level, 3);
  EXPECT_EQ (preset.clusters.s_alpha, 15.0);
  EXPECT_TRUE (preset.refit.enabled);
  const auto paper = KernelHoughTransformParameters::paper();
  expectSame (paper);
  EXPECT_FALSE (paper.merging.enabled);
  EXPECT_EQ (paper.phi_num, 80);
  EXPECT_EQ (paper.rho_num, 800);
  EXPECT_EQ (paper.clusters.first_level, 5);
  EXPECT_EQ (paper.clusters.s_alpha, 25.0);
  EXPECT_FALSE (paper.refit.enabled);
}

TEST (UpAxisPreset, DefaultAsksForSeventyPerCent)
{
  const UpAxisParameters preset;
  EXPECT_DOUBLE_EQ (preset.angle_tolerance, 7_deg);
  EXPECT_EQ (preset.min_share, 0.02);
  EXPECT_EQ (preset.min_confidence, 0.7);
}

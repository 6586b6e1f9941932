// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/angles.h>
#include <pcl/search/kdtree.h>

#include "paper/detect_as_in_paper.h"
#include "presets.h"
#include "scene.h"

using namespace pcl_ops::internal;
using pcl_ops::OrientedPointSamplingParameters;
using pcl_ops::PaperParameters;
using Strategy = PaperParameters::Strategy;
using Verification = PaperParameters::Verification;

namespace {

/** \brief The paper's algorithm in one of its variants. */
Ops
variantOn (const Cloud::ConstPtr& cloud,
           Strategy strategy,
           Verification verification = Verification::Samples,
           bool local_optimization = false)
{
  Ops ops = paperOn (cloud);
  OrientedPointSamplingParameters parameters = ops.getParameters();
  parameters.paper_only.strategy = strategy;
  parameters.paper_only.verification = verification;
  parameters.paper_only.local_optimization = local_optimization;
  ops.setParameters (parameters);
  return ops;
}

class EachVariant
: public ::testing::TestWithParam<std::tuple<Strategy, Verification, bool>> {};

} // namespace

TEST_P (EachVariant, FindsEverySurfaceOfARoom)
{
  const auto scene = room().build();
  const auto [strategy, verification, local_optimization] = GetParam();
  Ops ops = variantOn (scene.cloud, strategy, verification, local_optimization);
  expectFindsEverySurface (planesOf (ops), scene);
}

INSTANTIATE_TEST_SUITE_P (
    Paper,
    EachVariant,
    ::testing::Combine (
        ::testing::Values (Strategy::DetectThenDivide, Strategy::DivideThenDetect),
        ::testing::Values (Verification::Samples, Verification::AllPoints),
        ::testing::Bool()));

TEST (Strategy, NumbersAreThoseOfThePaper)
{
  EXPECT_EQ (static_cast<int> (Strategy::DetectThenDivide), 1);
  EXPECT_EQ (static_cast<int> (Strategy::DivideThenDetect), 2);
}

TEST (Strategy, OneDoesNotCareForTheUpAxisAndTwoFindsThePlanesWhateverItIs)
{
  const auto scene = room().build();
  Ops one = variantOn (scene.cloud, Strategy::DetectThenDivide);
  Ops two = variantOn (scene.cloud, Strategy::DivideThenDetect);
  const auto planes = inliersOf (one);
  for (const Eigen::Vector3f& up : {Eigen::Vector3f (0, 0, -2), {1, 0, 0}, {1, 2, 3}}) {
    one.setUpAxis (up);
    two.setUpAxis (up);
    EXPECT_EQ (inliersOf (one), planes);
    expectFindsEverySurface (planesOf (two), scene);
  }
}

TEST (Strategy, TwoDetectsPerGroupOfSamples)
{
  // The ramp of 3 m x 1 m crosses the floor, which takes no sample that is not flat.
  const auto scene =
      Scene().floor (3, 3).surface ({0, 1, -0.5}, {3, 0, 1}, {0, 1, 0}).build();
  OrientedSamples samples;
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    samples.add ((*scene.cloud)[i].getVector3fMap().cast<double>(),
                 scene.surfaces[static_cast<std::size_t> (scene.labels[i])].normal());
  const auto planes =
      extractPlanes ({}, samples, OrientedPointSamplingParameters::paper());
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_TRUE (isNear (planes[0], scene.surfaces[0], 1e-5, 1e-5));
  EXPECT_TRUE (isNear (planes[1], scene.surfaces[1], 1e-5, 1e-5));
}

TEST (MinSamples, OfZeroStillAsksForThreeSamples)
{
  auto parameters = OrientedPointSamplingParameters::paper();
  parameters.min_samples = 0;
  OrientedSamples samples;
  samples.add ({0, 0, 0}, Eigen::Vector3d::UnitZ());
  samples.add ({1, 0, 0}, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE (extractPlanes ({}, samples, parameters).empty());
  samples.add ({0, 1, 0}, Eigen::Vector3d::UnitZ());
  EXPECT_EQ (extractPlanes ({}, samples, parameters).size(), 1u);
}

TEST (Verification, CountsOnAllPointsWhereToldTo)
{
  // More samples are on the floor, more points on the table.
  OrientedSamples samples;
  Points points;
  for (int i = 0; i < 60; ++i)
    samples.add ({i % 7 * 1.0, i % 5 * 1.0, i < 40 ? 0.0 : 1.0},
                 Eigen::Vector3d::UnitZ());
  for (int i = 0; i < 1000; ++i)
    points.add (static_cast<float> (i % 7), static_cast<float> (i % 5), i < 40 ? 0 : 1);
  auto parameters = OrientedPointSamplingParameters::paper();
  parameters.min_samples = 10;
  const auto height_of_first = [&] {
    return -extractPlanes (points, samples, parameters).at (0).offset;
  };
  EXPECT_NEAR (std::abs (height_of_first()), 0.0, 1e-6);
  parameters.paper_only.verification = Verification::AllPoints;
  EXPECT_NEAR (std::abs (height_of_first()), 1.0, 1e-6);
}

TEST (Setters, WriteIntoTheParametersAndAreReadByTheirGetters)
{
  const auto search = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  Ops ops;
  ops.setParameters (OrientedPointSamplingParameters::paper());
  ops.setSamplingRate (0.2);
  ops.setKSearch (17);
  ops.setMinSamples (33);
  ops.setMinPoints (500);
  ops.setProbability (0.9);
  ops.setDistanceThreshold (0.07);
  ops.setUpAxis (Eigen::Vector3f (1, 2, 3));
  ops.setAngleTolerance (pcl::deg2rad (11.0f));
  ops.setSeed (99);
  ops.setNumberOfThreads (3);
  ops.setMergingParameters ({false, 7_deg, {}, {}});
  ops.setSearchMethod (search);
  EXPECT_EQ (ops.getSamplingRate(), 0.2);
  EXPECT_EQ (ops.getKSearch(), 17);
  EXPECT_EQ (ops.getMinSamples(), 33u);
  EXPECT_EQ (ops.getMinPoints(), 500u);
  EXPECT_EQ (ops.getProbability(), 0.9);
  EXPECT_EQ (ops.getDistanceThreshold(), 0.07);
  EXPECT_EQ (ops.getUpAxis(), Eigen::Vector3f (1, 2, 3));
  EXPECT_EQ (ops.getAngleTolerance(), pcl::deg2rad (11.0f));
  EXPECT_EQ (ops.getSeed(), 99u);
  EXPECT_EQ (ops.getNumberOfThreads(), 3u);
  EXPECT_FALSE (ops.getMergingParameters().enabled);
  EXPECT_EQ (ops.getSearchMethod(), search);
  EXPECT_EQ (ops.getParameters().k, 17);
  EXPECT_EQ (ops.getParameters().paper_only.strategy, Strategy::DivideThenDetect);
}

TEST (Setters, HaveTheNameOfTheInliersForTheMinimumOfSamples)
{
  Ops ops;
  ops.setMinInliers (44);
  EXPECT_EQ (ops.getMinSamples(), 44u);
  EXPECT_EQ (ops.getMinInliers(), 44u);
}

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

/** \brief For extractPlanes where samples alone verify planes. */
const Points no_points;

/** \brief Strategy, verification, and whether local_optimization is on. */
class EachVariant
: public ::testing::TestWithParam<std::tuple<Strategy, Verification, bool>> {};

} // namespace

TEST_P (EachVariant, FindsEverySurfaceOfARoom)
{
  const LabeledScene scene = room().build();
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
  const LabeledScene scene = room().build();
  Ops strategy_one = variantOn (scene.cloud, Strategy::DetectThenDivide);
  Ops strategy_two = variantOn (scene.cloud, Strategy::DivideThenDetect);
  const std::vector<pcl::Indices> inliers = inliersOf (strategy_one);
  ASSERT_FALSE (inliers.empty());
  for (const Eigen::Vector3f& up : {Eigen::Vector3f (0, 0, -2), {1, 0, 0}, {1, 2, 3}}) {
    strategy_one.setUpAxis (up);
    strategy_two.setUpAxis (up);
    EXPECT_EQ (inliersOf (strategy_one), inliers);
    expectFindsEverySurface (planesOf (strategy_two), scene);
  }
}

TEST (Strategy, TwoDetectsPerGroupOfSamples)
{
  // A ramp crosses the floor. The floor is detected among the level samples alone, so
  // its plane takes no sample of the ramp.
  const LabeledScene scene =
      Scene().floor (3, 3).surface ({0, 1, -0.5}, {3, 0, 1}, {0, 1, 0}).build();
  OrientedSamples samples;
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    samples.add ((*scene.cloud)[i].getVector3fMap().cast<double>(),
                 scene.surfaces[static_cast<std::size_t> (scene.labels[i])].normal());
  const std::vector<pcl_ops::Plane> planes =
      extractPlanes (no_points, samples, OrientedPointSamplingParameters::paper());
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_TRUE (isNear (planes[0], scene.surfaces[0], 1e-5, 1e-5));
  EXPECT_TRUE (isNear (planes[1], scene.surfaces[1], 1e-5, 1e-5));
}

TEST (MinSamples, OfZeroStillAsksForThreeSamples)
{
  OrientedPointSamplingParameters parameters = OrientedPointSamplingParameters::paper();
  parameters.min_samples = 0;
  OrientedSamples samples;
  samples.add ({0, 0, 0}, Eigen::Vector3d::UnitZ());
  samples.add ({1, 0, 0}, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE (extractPlanes (no_points, samples, parameters).empty());
  samples.add ({0, 1, 0}, Eigen::Vector3d::UnitZ());
  EXPECT_EQ (extractPlanes (no_points, samples, parameters).size(), 1u);
}

TEST (Verification, CountsOnAllPointsWhereToldTo)
{
  // A floor at z = 0 has 40 of 60 samples, but only 40 of 1000 points; the rest is on a
  // table at 1 m.
  constexpr int on_floor = 40;
  OrientedSamples samples;
  Points points;
  for (int i = 0; i < 60; ++i)
    samples.add ({i % 7 * 1.0, i % 5 * 1.0, i < on_floor ? 0.0 : 1.0},
                 Eigen::Vector3d::UnitZ());
  for (int i = 0; i < 1000; ++i)
    points.add (
        static_cast<float> (i % 7), static_cast<float> (i % 5), i < on_floor ? 0 : 1);
  OrientedPointSamplingParameters parameters = OrientedPointSamplingParameters::paper();
  parameters.min_samples = 10;
  const auto heightOfFirstPlane = [&] {
    return -extractPlanes (points, samples, parameters).at (0).offset;
  };
  EXPECT_NEAR (std::abs (heightOfFirstPlane()), 0.0, 1e-6);
  parameters.paper_only.verification = Verification::AllPoints;
  EXPECT_NEAR (std::abs (heightOfFirstPlane()), 1.0, 1e-6);
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
  pcl_ops::MergingParameters disabled;
  disabled.enabled = false;
  ops.setMergingParameters (disabled);
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

TEST (Setters, SetMinInliersSetsTheMinimumOfSamples)
{
  Ops ops;
  ops.setMinInliers (44);
  EXPECT_EQ (ops.getMinSamples(), 44u);
  EXPECT_EQ (ops.getMinInliers(), 44u);
}

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sample_consensus/lmeds.h>
#include <pcl/sample_consensus/mlesac.h>
#include <pcl/sample_consensus/msac.h>
#include <pcl/sample_consensus/prosac.h>
#include <pcl/sample_consensus/ransac.h>

#include "scene.h"
#include <pcl_ops/sac_model_oriented_point.h>

namespace {

using Cloud = pcl::PointCloud<pcl::PointNormal>;
using Model = pcl_ops::SampleConsensusModelOrientedPoint<pcl::PointNormal>;

/** \brief A cloud whose first points are on the plane z = 1 m. The other points are
 * above it, each at a height of its own. All normals point up.
 * \param[in] inlier_share number of points on the plane over number of points
 * \param[in] size number of points */
Cloud::Ptr
cloudWithPlane (double inlier_share, std::size_t size = 1000)
{
  const auto cloud = pcl::make_shared<Cloud>();
  RandomGenerator generator (seedOfTest());
  for (std::size_t i = 0; i < size; ++i) {
    const auto index = static_cast<float> (i);
    const auto x = static_cast<float> (drawUnit (generator));
    const auto y = static_cast<float> (drawUnit (generator));
    const bool is_on_plane = index < size * inlier_share;
    cloud->push_back ({x, y, is_on_plane ? 1.0f : 2.0f + index, 0, 0, 1});
  }
  return cloud;
}

/** \brief pcl::RandomSampleConsensus with public access to its iteration count. */
struct CountingRansac : pcl::RandomSampleConsensus<pcl::PointNormal> {
  using pcl::RandomSampleConsensus<pcl::PointNormal>::RandomSampleConsensus;
  using pcl::RandomSampleConsensus<pcl::PointNormal>::iterations_;
};

/** \brief p: probability that RANSAC draws a point of the plane. */
constexpr double probability = 0.99;
constexpr std::uint32_t seeds = 21; // odd, so that one of the runs is the median

/** \brief Numbers of iterations of RANSAC with \ref probability on \ref cloudWithPlane,
 * one for each seed, ascending. */
std::vector<int>
sortedIterations (double inlier_share)
{
  const auto cloud = cloudWithPlane (inlier_share);
  std::vector<int> iterations;
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    const auto model = pcl::make_shared<Model> (cloud);
    model->setSeed (seed);
    CountingRansac ransac (model, 5_cm);
    ransac.setProbability (probability);
    EXPECT_TRUE (ransac.computeModel());
    iterations.push_back (ransac.iterations_);
  }
  std::sort (iterations.begin(), iterations.end());
  return iterations;
}

/** \brief The points of the next samples that a model draws: a sample is one point. */
pcl::Indices
drawSamples (Model& model, int number)
{
  pcl::Indices drawn, sample;
  for (int i = 0; i < number; ++i) {
    int iterations = 0;
    model.getSamples (iterations, sample);
    drawn.push_back (sample.at (0));
  }
  return drawn;
}

} // namespace

template <typename EstimatorT>
class OrientedPointModelBy : public ::testing::Test {};

// Not RRANSAC and RMSAC: before PCL 1.15 they test each model on a tenth of the points
// first and may never end, whatever the model is.
using Estimators =
    ::testing::Types<pcl::RandomSampleConsensus<pcl::PointNormal>,
                     pcl::MEstimatorSampleConsensus<pcl::PointNormal>,
                     pcl::MaximumLikelihoodSampleConsensus<pcl::PointNormal>,
                     pcl::ProgressiveSampleConsensus<pcl::PointNormal>,
                     pcl::LeastMedianSquares<pcl::PointNormal>>;
TYPED_TEST_SUITE (OrientedPointModelBy, Estimators);

TYPED_TEST (OrientedPointModelBy, AnEstimatorOfPclIsThePlaneOfMostPoints)
{
  const auto cloud = cloudWithPlane (0.7);
  TypeParam estimator (pcl::make_shared<Model> (cloud), 5_cm);
  ASSERT_TRUE (estimator.computeModel());
  Eigen::VectorXf coefficients;
  pcl::Indices inliers;
  estimator.getModelCoefficients (coefficients);
  estimator.getInliers (inliers);
  EXPECT_TRUE (coefficients.isApprox (Eigen::Vector4f (0, 0, 1, -1), 1e-5f));
  EXPECT_EQ (inliers.size(), 700u) << "of 1000";
}

TEST (OrientedPointModel, MakesPclsRansacEndAfterTheIterationsThatThePaperSays)
{
  // A run ends after N_iter = log (1 - p) / log (1 - w) draws if one of the drawn
  // points is on the plane, which has a share w of the points. That happens with
  // probability p.
  for (const double w : {0.1, 0.2, 0.5, 0.7}) {
    const std::vector<int> iterations = sortedIterations (w);
    const int n_iter = static_cast<int> (
        std::ceil (std::log (1.0 - probability) / std::log (1.0 - w)));
    EXPECT_GE (iterations.front(), n_iter) << "w = " << w;
    const int median = iterations[seeds / 2];
    EXPECT_LE (median, n_iter + 1) << "w = " << w;
  }
}

TEST (OrientedPointModel, IsThePlaneThroughAPointPerpendicularToItsNormal)
{
  const auto cloud = pcl::make_shared<Cloud>();
  cloud->push_back ({1, 2, 3, 0, 0, 0});     // no normal
  cloud->push_back ({1, 2, 3, NAN, 0, 1});   // no finite normal
  cloud->push_back ({NAN, 2, 3, 0, 0, 1});   // no finite point
  cloud->push_back ({1, 2, 3, 0, 0, 1e20f}); // no finite squared length
  constexpr pcl::index_t valid = 4;
  cloud->push_back ({1, 2, 3, 0, 0, 2}); // a normal of length 2
  const Model model (cloud);
  Eigen::VectorXf coefficients;
  for (const pcl::Indices& sample : std::vector<pcl::Indices>{
           {0}, {1}, {2}, {3}, {}, {valid, valid}}) // a sample is one point
    EXPECT_FALSE (model.computeModelCoefficients (sample, coefficients));
  ASSERT_TRUE (model.computeModelCoefficients ({valid}, coefficients));
  EXPECT_TRUE (coefficients.isApprox (Eigen::Vector4f (0, 0, 1, -3)));
}

TEST (OrientedPointModel, RefitsToTheInliersAndKeepsTheSideOfTheNormal)
{
  const auto cloud = cloudWithPlane (1.0, 100);
  const auto all = upTo<pcl::Indices> (cloud->size());
  for (const float side : {1.0f, -1.0f}) {
    Eigen::VectorXf hypothesis (4), refitted;
    hypothesis << side * 0.1f, 0, side * 0.995f, -side; // 6 degrees off
    Model (cloud).optimizeModelCoefficients (all, hypothesis, refitted);
    EXPECT_TRUE (refitted.isApprox (side * Eigen::Vector4f (0, 0, 1, -1), 1e-5f));
  }
}

TEST (OrientedPointModel, KeepsItsHypothesisWhereNoPlaneFitsOrAConstraintForbidsIt)
{
  const auto cloud = pcl::make_shared<Cloud>();
  for (const float i : {0.0f, 1.0f, 2.0f, 3.0f, 4.0f}) // on a line
    cloud->push_back ({i, i, i, 0, 0, 1});
  Eigen::VectorXf hypothesis (4), refitted;
  hypothesis << 0.1f, 0, 0.995f, -1;
  for (const pcl::Indices& inliers :
       {pcl::Indices{}, pcl::Indices{0, 1}, pcl::Indices{0, 1, 2, 3, 4}}) {
    Model (cloud).optimizeModelCoefficients (inliers, hypothesis, refitted);
    EXPECT_EQ (refitted, hypothesis);
  }
  Model model (cloudWithPlane (1.0, 100));
  // The refitted plane, z = 1, has an x of its normal of 0.
  model.setModelConstraints (
      [] (const Eigen::VectorXf& coefficients) { return coefficients[0] > 0.05f; });
  model.optimizeModelCoefficients ({0, 1, 2, 3, 4, 5}, hypothesis, refitted);
  EXPECT_EQ (refitted, hypothesis) << "the constraint forbids z = 1";
}

TEST (OrientedPointModel, DrawsTheSameSamplesForTheSameSeed)
{
  const auto cloud = cloudWithPlane (0.5);
  Model first (cloud), again (cloud), other (cloud);
  first.setSeed (7);
  again.setSeed (7);
  other.setSeed (8);
  const pcl::Indices drawn = drawSamples (first, 20);
  EXPECT_EQ (drawSamples (again, 20), drawn);
  EXPECT_NE (drawSamples (other, 20), drawn);
  first.setSeed (7);
  EXPECT_EQ (drawSamples (first, 20), drawn) << "the seed was set once more";
}

TEST (OrientedPointModel, UsesTheGivenIndicesAlone)
{
  const auto cloud = cloudWithPlane (0.5); // points 0 to 499 are on the plane
  const pcl::Indices given{0, 1, 2, 3, 900, 950};
  pcl::RandomSampleConsensus<pcl::PointNormal> ransac (
      pcl::make_shared<Model> (cloud, given), 5_cm);
  ASSERT_TRUE (ransac.computeModel());
  pcl::Indices inliers;
  ransac.getInliers (inliers);
  EXPECT_EQ (inliers, (pcl::Indices{0, 1, 2, 3}));
}

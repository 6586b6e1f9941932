// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/point_extraction.h"
#include "scene.h"

using namespace pcl_ops::internal;
using pcl_ops::Plane;

namespace {

/** \brief Every point of a scene as a sample with the normal of its surface. The normal
 * of a point of the clutter is a random direction.
 * \param[in] normal_noise standard deviation of the error of each component of a unit
 * normal */
OrientedSamples
samplesOf (const LabeledScene& scene, double normal_noise = 0.0)
{
  RandomGenerator generator (seedOfTest());
  OrientedSamples samples;
  for (std::size_t i = 0; i < scene.labels.size(); ++i) {
    const Eigen::Vector3d random = drawGaussians (generator);
    const int label = scene.labels[i];
    const bool is_clutter = label < 0;
    const Eigen::Vector3d normal =
        is_clutter ? random
                   : scene.surfaces[static_cast<std::size_t> (label)].normal() +
                         normal_noise * random;
    samples.add ((*scene.cloud)[i].getVector3fMap().cast<double>(),
                 normal.normalized());
  }
  return samples;
}

/** \brief Surface 0, a floor, is twice as large as surface 1, a wall; 10 % of the
 * points are clutter. */
Scene
floorAndSmallerWall ()
{
  return Scene()
      .floor (4_m, 2_m)
      .wall ({0, 0}, {2, 0}, 2_m)
      .spacing (10_cm)
      .clutter (10_percent);
}

const Plane floor_plane{Eigen::Vector3d::UnitZ(), 0.0};

RansacParameters
parametersWithThreshold ()
{
  RansacParameters parameters;
  parameters.distance_threshold = theta_h;
  return parameters;
}

/** \brief The plane that one-point RANSAC finds, if any. */
std::optional<Plane>
planeByRansac (Candidates candidates,
               const RansacParameters& parameters = parametersWithThreshold(),
               std::uint32_t seed = seedOfTest())
{
  RandomGenerator generator (seed);
  return onePointRansac (candidates, parameters, generator);
}

/** \brief The plane that largestPlane finds among all samples; throws if there is none.
 */
ExtractedPlane
largestAmong (const OrientedSamples& samples,
              const RansacParameters& parameters,
              std::uint32_t seed = seedOfTest())
{
  RandomGenerator generator (seed);
  return largestPlane ({samples, upTo (samples.size())}, parameters, generator).value();
}

} // namespace

TEST (RequiredDraws, IsTheLogarithmOfFailureOverThatOfAMissRoundedUp)
{
  // log (1 - p) / log (1 - w) for the probability p and the inlier ratio w
  EXPECT_EQ (requiredDraws (0.99, 0.8), 3u);    // log 0.01 / log 0.2 = 2.9
  EXPECT_EQ (requiredDraws (0.99, 0.5), 7u);    // log 0.01 / log 0.5 = 6.6
  EXPECT_EQ (requiredDraws (0.99, 0.1), 44u);   // log 0.01 / log 0.9 = 43.7
  EXPECT_EQ (requiredDraws (0.99, 0.01), 459u); // log 0.01 / log 0.99 = 458.2
  EXPECT_EQ (requiredDraws (0.95, 0.2), 14u);   // log 0.05 / log 0.8 = 13.4
}

TEST (RequiredDraws, IsOneWhereEveryPointIsAnInlierAndLargeButFiniteWhereNoneIs)
{
  EXPECT_EQ (requiredDraws (0.99, 1.0), 1u);
  EXPECT_EQ (requiredDraws (0.99, 1.5), 1u);
  constexpr std::size_t billion = 1000000000;
  constexpr std::size_t largest = std::numeric_limits<std::int32_t>::max();
  for (const double no_inliers : {0.0, -0.5, 1e-300}) {
    EXPECT_GT (requiredDraws (0.99, no_inliers), billion);
    EXPECT_LE (requiredDraws (0.99, no_inliers), largest);
  }
}

TEST (WithinDistance, SelectsAmongTheCandidatesOnly)
{
  Coordinates positions;
  for (int i = 0; i < 5; ++i)
    positions.add (1.0f, 2.0f, 0.0f);
  EXPECT_EQ (selectWithinDistance (positions, {0, 3}, floor_plane, theta_h),
             (Indices{0, 3}));
}

TEST (WithinDistance, AgreesWithBruteForce)
{
  const auto samples = samplesOf (floorAndSmallerWall().build());
  const Plane tilted =
      pcl_ops::planeThrough ({1, 1, 1}, Eigen::Vector3d (1, 2, 3).normalized());
  constexpr double threshold = 30_cm;
  Indices within;
  for (std::uint32_t i = 0; i < samples.size(); ++i)
    if (std::abs (tilted.distance (samples[i])) < threshold)
      within.push_back (i);
  ASSERT_FALSE (within.empty());
  EXPECT_EQ (countWithinDistance (samples, tilted, threshold), within.size());
  EXPECT_EQ (selectWithinDistance (samples, upTo (samples.size()), tilted, threshold),
             within);
}

TEST (OnePointRansac, FindsThePlaneWithMostInliers)
{
  const auto scene = floorAndSmallerWall().build();
  const auto samples = samplesOf (scene);
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Candidates all{samples, upTo (samples.size())};
    const auto plane = planeByRansac (all, parametersWithThreshold(), seed);
    EXPECT_TRUE (isNear (plane.value(), scene.surfaces[0], 1e-6, 1e-6));
  }
}

TEST (OnePointRansac, DrawsFromTheCandidatesOnly)
{
  const auto scene = floorAndSmallerWall().build();
  const auto samples = samplesOf (scene);
  Indices on_wall;
  for (std::uint32_t i = 0; i < samples.size(); ++i)
    if (scene.labels[i] == 1)
      on_wall.push_back (i);
  const auto plane = planeByRansac ({samples, on_wall});
  EXPECT_TRUE (isNear (plane.value(), scene.surfaces[1], 1e-6, 1e-6));
}

TEST (OnePointRansac, NeedsMoreThanThetaNSamplesEvenIfItIsVerifiedOnAllPoints)
{
  // Ten candidates on a floor of a thousand points. theta_N, min_samples, always counts
  // samples, also if hypotheses are verified on all points.
  const auto samples = samplesOf (Scene().floor (4_m, 2.5_m).spacing (10_cm).build());
  Coordinates all_points = samples;
  Coordinates* const on_samples = nullptr;
  Coordinates* const on_all_points = &all_points;
  RansacParameters parameters = parametersWithThreshold();
  for (Coordinates* const verified : {on_samples, on_all_points})
    for (const std::size_t min_samples : {9, 10}) {
      parameters.min_samples = min_samples;
      const Candidates ten_samples{samples, upTo (10), verified};
      EXPECT_EQ (planeByRansac (ten_samples, parameters).has_value(), min_samples < 10);
    }
}

TEST (OnePointRansac, FindsNothingAmongNoCandidatesOrPointsOnNoPlane)
{
  OrientedSamples scattered;
  for (int i = 0; i < 100; ++i)
    scattered.add (Eigen::Vector3d::Constant (i), Eigen::Vector3d::Ones().normalized());
  for (const std::size_t number : {0, 100})
    EXPECT_FALSE (planeByRansac ({scattered, upTo (number)}));
}

TEST (LargestPlane, IsRefittedToItsInliers)
{
  const auto scene = floorAndSmallerWall().noise (1_cm).build();
  const auto samples = samplesOf (scene, 0.01);
  RansacParameters parameters = parametersWithThreshold();
  parameters.paper_only.local_optimization = false;
  const ExtractedPlane found = largestAmong (samples, parameters);
  pcl_ops::Moments moments;
  for (const std::uint32_t i : found.inliers)
    moments.add (samples.x[i], samples.y[i], samples.z[i]);
  const pcl_ops::PlaneFit fit = fitPlane (moments).value();
  EXPECT_LT (angleBetween (found.plane.normal, fit.plane.normal), 1e-9);
  EXPECT_NEAR (found.plane.distance (fit.centroid), 0.0, 1e-9);
}

TEST (LargestPlane, HasMoreInliersWithLocalOptimization)
{
  const auto scene = floorAndSmallerWall().noise (1_cm).build();
  const auto samples = samplesOf (scene, 0.05);
  std::size_t more_inliers = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    RansacParameters parameters = parametersWithThreshold();
    // The wall is half as large as the floor. This probability needs so many draws that
    // some of them are on the floor with any seed.
    parameters.paper_only.probability = 1.0 - 1e-9;
    const ExtractedPlane optimized = largestAmong (samples, parameters, seed);
    parameters.paper_only.local_optimization = false;
    const ExtractedPlane plain = largestAmong (samples, parameters, seed);
    EXPECT_GE (optimized.inliers.size(), plain.inliers.size());
    more_inliers += optimized.inliers.size() - plain.inliers.size();
    EXPECT_TRUE (isNear (optimized.plane, scene.surfaces[0], 1_deg, 1_cm));
  }
  EXPECT_GT (more_inliers, 0u);
}

TEST (ExtractAll, FindsTheLargestFirstAndRemovesTheirInliersFromSamplesAndPoints)
{
  const auto scene = floorAndSmallerWall().build();
  const auto samples = samplesOf (scene);
  Coordinates points_left = samples;
  RandomGenerator generator (seedOfTest());
  Candidates candidates{samples, upTo (samples.size()), &points_left};
  const auto planes = extractAll (candidates, parametersWithThreshold(), generator);
  ASSERT_EQ (planes.size(), 2u);
  Indices left_or_on_plane = candidates.free_samples;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    EXPECT_TRUE (isNear (planes[p].plane, scene.surfaces[p], 1_deg, 1_cm));
    EXPECT_EQ (countWithinDistance (points_left, planes[p].plane, theta_h), 0u);
    left_or_on_plane.insert (
        left_or_on_plane.end(), planes[p].inliers.begin(), planes[p].inliers.end());
  }
  std::sort (left_or_on_plane.begin(), left_or_on_plane.end());
  EXPECT_EQ (left_or_on_plane, upTo (samples.size()));
  EXPECT_EQ (points_left.size(), candidates.free_samples.size());
}

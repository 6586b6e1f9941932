// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/point_extraction.h"
#include "scene.h"

using namespace pcl_ops::internal;
using pcl_ops::Plane;

namespace {

/** \brief Every point of a scene as a sample with the normal of its surface; a point of
 * the clutter has any normal.
 * \param[in] normal_noise standard deviation of each component of the normals */
OrientedSamples
samplesOf (const LabelledScene& scene, double normal_noise = 0.0)
{
  RandomGenerator generator (seedOfTest());
  OrientedSamples samples;
  for (std::size_t i = 0; i < scene.labels.size(); ++i) {
    const Eigen::Vector3d any = drawGaussians (generator);
    const int label = scene.labels[i];
    const bool is_clutter = label < 0;
    const Eigen::Vector3d normal =
        is_clutter ? any
                   : scene.surfaces[static_cast<std::size_t> (label)].normal() +
                         normal_noise * any;
    samples.add ((*scene.cloud)[i].getVector3fMap().cast<double>(),
                 normal.normalized());
  }
  return samples;
}

/** \brief A floor twice as large as a wall, and clutter. */
Scene
floorAndWall ()
{
  return Scene()
      .floor (4_m, 2_m)
      .wall ({0, 0}, {2, 0}, 2_m)
      .spacing (10_cm)
      .clutter (10_percent);
}

const Plane floor_plane{Eigen::Vector3d::UnitZ(), 0.0};

RansacParameters
withinFiveCentimeters ()
{
  RansacParameters parameters;
  parameters.distance_threshold = 5_cm;
  return parameters;
}

std::optional<Plane>
planeByRansac (Candidates candidates,
               const RansacParameters& parameters = withinFiveCentimeters(),
               std::uint32_t seed = seedOfTest())
{
  RandomGenerator generator (seed);
  return onePointRansac (candidates, parameters, generator);
}

ExtractedPlane
largestAmong (const OrientedSamples& samples,
              const RansacParameters& parameters,
              std::uint32_t seed = seedOfTest())
{
  RandomGenerator generator (seed);
  return largestPlane ({samples, upTo (samples.size())}, parameters, generator).value();
}

} // namespace

TEST (RequiredDraws, MatchesTheFormula)
{
  EXPECT_EQ (requiredDraws (0.99, 0.8), 3u);    // log 0.01 / log 0.2 = 2.9
  EXPECT_EQ (requiredDraws (0.99, 0.5), 7u);    // 6.6
  EXPECT_EQ (requiredDraws (0.99, 0.1), 44u);   // 43.7
  EXPECT_EQ (requiredDraws (0.99, 0.01), 459u); // 458.2
  EXPECT_EQ (requiredDraws (0.95, 0.2), 14u);   // 13.4
}

TEST (RequiredDraws, IsOneWhereEveryPointIsAnInlierAndLargeButFiniteWhereNoneIs)
{
  EXPECT_EQ (requiredDraws (0.99, 1.0), 1u);
  EXPECT_EQ (requiredDraws (0.99, 1.5), 1u);
  for (const double no_inliers : {0.0, -0.5, 1e-300}) {
    EXPECT_GT (requiredDraws (0.99, no_inliers), 1000000000u);
    EXPECT_LE (requiredDraws (0.99, no_inliers), 2147483647u);
  }
}

TEST (WithinDistance, SelectsAmongTheCandidatesOnly)
{
  Coordinates positions;
  for (int i = 0; i < 5; ++i)
    positions.add (1.0f, 2.0f, 0.0f);
  EXPECT_EQ (selectWithinDistance (positions, {0, 3}, floor_plane, 5_cm),
             (Indices{0, 3}));
}

TEST (WithinDistance, AgreesWithBruteForce)
{
  const auto samples = samplesOf (floorAndWall().build());
  const Plane tilted =
      pcl_ops::planeThrough ({1, 1, 1}, Eigen::Vector3d (1, 2, 3).normalized());
  std::size_t near = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    near += std::abs (tilted.distance (samples[i])) < 30_cm;
  EXPECT_EQ (countWithinDistance (samples, tilted, 30_cm), near);
  EXPECT_EQ (
      selectWithinDistance (samples, upTo (samples.size()), tilted, 30_cm).size(),
      near);
}

TEST (OnePointRansac, FindsThePlaneWithMostInliers)
{
  const auto scene = floorAndWall().build();
  const auto samples = samplesOf (scene);
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Candidates all{samples, upTo (samples.size())};
    const auto plane = planeByRansac (all, withinFiveCentimeters(), seed);
    EXPECT_TRUE (isNear (plane.value(), scene.surfaces[0], 1e-6, 1e-6));
  }
}

TEST (OnePointRansac, DrawsFromTheCandidatesOnly)
{
  const auto scene = floorAndWall().build();
  const auto samples = samplesOf (scene);
  Indices on_wall;
  for (std::uint32_t i = 0; i < samples.size(); ++i)
    if (scene.labels[i] == 1)
      on_wall.push_back (i);
  const auto plane = planeByRansac ({samples, on_wall});
  EXPECT_TRUE (isNear (plane.value(), scene.surfaces[1], 1e-6, 1e-6));
}

TEST (OnePointRansac, WantsMoreCandidatesThanThetaNWhateverItVerifiesOn)
{
  // Ten candidates on a floor that has a thousand points.
  const auto samples = samplesOf (Scene().floor (4_m, 2.5_m).spacing (10_cm).build());
  Coordinates all_points = samples;
  Coordinates* const on_samples = nullptr;
  RansacParameters parameters = withinFiveCentimeters();
  for (Coordinates* const verified : {on_samples, &all_points})
    for (const std::size_t min_samples : {9, 10}) {
      parameters.min_samples = min_samples;
      EXPECT_EQ (planeByRansac ({samples, upTo (10), verified}, parameters).has_value(),
                 min_samples < 10);
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
  const auto scene = floorAndWall().noise (1_cm).build();
  const auto samples = samplesOf (scene, 0.01);
  RansacParameters parameters = withinFiveCentimeters();
  parameters.paper_only.local_optimization = false;
  const ExtractedPlane found = largestAmong (samples, parameters);
  pcl_ops::Moments moments;
  for (const std::uint32_t i : found.inliers)
    moments.add (samples.x[i], samples.y[i], samples.z[i]);
  const pcl_ops::PlaneFit fit = fitPlane (moments).value();
  EXPECT_LT (angleBetween (found.plane.normal, fit.plane.normal), 1e-9);
  EXPECT_NEAR (found.plane.distance (fit.centroid), 0.0, 1e-9);
}

TEST (LargestPlane, GrowsItsSupportByLocalOptimisation)
{
  const auto scene = floorAndWall().noise (1_cm).build();
  const auto samples = samplesOf (scene, 0.05);
  std::size_t more_inliers = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    RansacParameters parameters = withinFiveCentimeters();
    // The wall is half as large as the floor. This probability asks for so many draws
    // that some hit the floor with any seed.
    parameters.paper_only.probability = 1.0 - 1e-9;
    const ExtractedPlane grown = largestAmong (samples, parameters, seed);
    parameters.paper_only.local_optimization = false;
    const ExtractedPlane plain = largestAmong (samples, parameters, seed);
    EXPECT_GE (grown.inliers.size(), plain.inliers.size());
    more_inliers += grown.inliers.size() - plain.inliers.size();
    EXPECT_TRUE (isNear (grown.plane, scene.surfaces[0], 1_deg, 1_cm));
  }
  EXPECT_GT (more_inliers, 0u);
}

TEST (ExtractAll, FindsTheLargestFirstAndTakesThemOutOfSamplesAndRemainingPoints)
{
  const auto scene = floorAndWall().build();
  const auto samples = samplesOf (scene);
  Coordinates remaining = samples;
  RandomGenerator generator (seedOfTest());
  Candidates candidates{samples, upTo (samples.size()), &remaining};
  const auto planes = extractAll (candidates, withinFiveCentimeters(), generator);
  ASSERT_EQ (planes.size(), 2u);
  Indices all = candidates.samples_left;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    EXPECT_TRUE (isNear (planes[p].plane, scene.surfaces[p], 1_deg, 1_cm));
    EXPECT_EQ (countWithinDistance (remaining, planes[p].plane, 5_cm), 0u);
    all.insert (all.end(), planes[p].inliers.begin(), planes[p].inliers.end());
  }
  std::sort (all.begin(), all.end());
  EXPECT_EQ (all, upTo (samples.size()));
  EXPECT_EQ (remaining.size(), candidates.samples_left.size());
}

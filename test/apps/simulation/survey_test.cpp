// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_checks.h"
#include "simulated_scene.h"
#include <simulation/survey.h>

using namespace pcl_ops::simulation;

namespace {

/** \brief Four houses, whose smallest walls still get a hundred points or so. */
SimulatedCloud
smallSurvey (std::uint32_t seed, double noise_scale)
{
  return scanSurvey (makeSurvey (seed, 4), 10000, noise_scale, seed);
}

/** \brief A single house in the middle of its ground, with a ridge along x. */
Survey
lonelyHouse ()
{
  Survey survey;
  survey.houses.emplace_back();
  survey.width = 30.0;
  return survey;
}

} // namespace

TEST (Survey, HasAGroundAndSixPlanesForEachHouse)
{
  const std::uint32_t seed = seedOfTest();
  for (const std::size_t houses : {1u, 3u, 5u}) {
    const Survey survey = makeSurvey (seed, houses);
    EXPECT_EQ (scanSurvey (survey, 5000 * houses, 1.0, seed).planes.size(),
               1 + planes_of_house * houses);
  }
}

TEST (Survey, HasExactlyThePointsAskedFor)
{
  const Survey survey = makeSurvey (seedOfTest(), 2);
  for (const std::size_t points : {1u, 999u})
    EXPECT_EQ (scanSurvey (survey, points, 1.0, 1).cloud.size(), points);
}

TEST (Survey, EveryPointIsOnAPlane)
{
  for (const auto& point : smallSurvey (seedOfTest(), 1.0).cloud)
    ASSERT_GT (point.label, 0u);
}

TEST (Survey, ExactPointsLieOnThePlaneOfTheirLabel)
{
  constexpr double times_larger = 5.0; // than a room
  EXPECT_LT (largestDistanceToTruth (smallSurvey (seedOfTest(), 0.0)),
             times_larger * rounding);
}

TEST (Survey, NoisyPointsLieAroundThePlaneOfTheirLabel)
{
  const double largest = largestDistanceToTruth (smallSurvey (seedOfTest(), 2.0));
  EXPECT_LT (largest, 2.0 * survey_sigma * largest_gaussian * std::sqrt (3.0));
  EXPECT_GT (largest, 2.0 * survey_sigma * 2.0);
}

TEST (Survey, ThereIsNoGroundInAHouse)
{
  const Survey survey = lonelyHouse();
  for (const auto& point : scanSurvey (survey, 5000, 0.0, seedOfTest()).cloud) {
    const bool is_inside = std::abs (point.x) < 7.4f && std::abs (point.y) < 5.4f;
    EXPECT_FALSE (is_inside && point.z < 4.9f);
  }
}

TEST (Survey, NothingSticksOutOfTheRoof)
{
  const Survey survey = lonelyHouse();
  const House& house = survey.houses.front();
  const double rise = 2.0 * (house.ridge - house.eaves) / house.width;
  for (const auto& point : scanSurvey (survey, 5000, 0.0, seedOfTest()).cloud)
    if (point.z > 0.0f) {
      EXPECT_LT (point.z, house.ridge - rise * std::abs (point.y) + 5.0 * rounding);
    }
}

TEST (Survey, PointsComeInNoOrder)
{
  const auto cloud = smallSurvey (seedOfTest(), 1.0).cloud;
  std::size_t changes = 0;
  for (std::size_t i = 1; i < cloud.size(); ++i)
    changes += cloud[i].label != cloud[i - 1].label;
  EXPECT_GT (changes, cloud.size() / 4);
}

TEST (Survey, SensorsPositionIsNotKnown)
{
  const auto cloud = smallSurvey (seedOfTest(), 1.0).cloud;
  EXPECT_TRUE (cloud.sensor_origin_.isZero());
  EXPECT_TRUE (cloud.sensor_orientation_.isApprox (Eigen::Quaternionf::Identity()));
}

TEST (Survey, SameSeedSameCloud)
{
  const std::uint32_t seed = seedOfTest();
  const auto first = smallSurvey (seed, 1.0);
  EXPECT_TRUE (haveSamePoints (first, smallSurvey (seed, 1.0)));
  EXPECT_FALSE (haveSamePoints (first, smallSurvey (seed + 1, 1.0)));
}

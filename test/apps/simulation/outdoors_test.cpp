// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/street_things.h>
#include <simulation/survey.h>
#include <simulation/town.h>

#include <array>
#include <map>
#include <set>

using namespace pcl_ops::simulation;

namespace {

constexpr double some_points = 1e5;

/** \brief A single house in the middle of its ground, with a ridge along x. */
Survey
lonelyHouse ()
{
  Survey survey;
  survey.houses.emplace_back();
  survey.width = 30.0;
  return survey;
}

/** \brief The points of all tiles, sorted. */
std::vector<TownPoint>
allPoints (const Town& town)
{
  std::vector<TownPoint> points;
  for (std::uint32_t row = 0; row < town.tiles; ++row)
    for (std::uint32_t column = 0; column < town.tiles; ++column)
      for (const TownPoint& point : surveyTile (town, column, row, 1.0))
        points.push_back (point);
  const auto key = [] (const TownPoint& point) {
    const Eigen::Vector3d& p = point.position;
    return std::array<double, 3>{p.x(), p.y(), p.z()};
  };
  std::sort (points.begin(), points.end(), [&] (const auto& a, const auto& b) {
    return key (a) < key (b);
  });
  return points;
}

} // namespace

TEST (Survey, HasAGroundAndSixPlanesForEachHouse)
{
  const std::uint32_t seed = seedOfTest();
  for (const std::size_t houses : {1u, 3u, 5u}) {
    const auto simulated =
        scanSurvey (makeSurvey (seed, houses), 5000 * houses, 1.0, seed);
    EXPECT_EQ (simulated.planes.size(), 1 + planes_of_house * houses);
    for (const auto& point : simulated.cloud)
      ASSERT_GT (point.label, 0u);
  }
}

TEST (Survey, HasNoGroundInAHouseAndNothingOutOfTheRoof)
{
  const Survey survey = lonelyHouse();
  const House& house = survey.houses.front();
  const double rise = 2.0 * (house.ridge - house.eaves) / house.width;
  for (const auto& point : scanSurvey (survey, 5000, 0.0, seedOfTest()).cloud) {
    const bool is_inside = std::abs (point.x) < 7.4f && std::abs (point.y) < 5.4f;
    EXPECT_FALSE (is_inside && point.z < 4.9f);
    if (point.z > 0.0f) {
      EXPECT_LT (point.z, house.ridge - rise * std::abs (point.y) + 5.0 * rounding);
    }
  }
}

TEST (Town, HasTheSamePointsInAnyNumberOfTiles)
{
  const auto one = allPoints (makeTown (1, some_points, 1));
  const auto nine = allPoints (makeTown (1, some_points, 8));
  ASSERT_EQ (one.size(), nine.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ (one[i].position, nine[i].position);
    ASSERT_EQ (one[i].label, nine[i].label);
  }
}

TEST (Town, HasAboutAsManyPointsAsAskedFor)
{
  constexpr double many_points = 1e6;
  const auto found = double (allPoints (makeTown (1, many_points, 4)).size());
  EXPECT_NEAR (found / many_points, 1.0, 0.2);
}

TEST (Town, HasAPlaneForEachLabel)
{
  constexpr double enough_points = 500;
  std::map<std::uint32_t, pcl_ops::Moments> planes;
  const Town town = makeTown (2, some_points, 1);
  for (const TownPoint& point : surveyTile (town, 0, 0, 1.0)) {
    const Eigen::Vector3d local = point.position - town.corner;
    planes[point.label].add (local.x(), local.y(), local.z());
  }
  EXPECT_GT (planes.size(), 10u);
  for (const auto& [label, moments] : planes)
    if (moments.count >= enough_points) {
      const auto fit = pcl_ops::fitPlane (moments);
      ASSERT_TRUE (fit);
      EXPECT_NEAR (std::sqrt (fit->variances[0]), survey_sigma, 0.002) << label;
    }
}

TEST (Street, PlantsAndPolesAreOnNoPlane)
{
  Random random (seedOfTest());
  for (const Body& body :
       {drawTree (random), drawBush (0.5, random), drawPole (random)}) {
    EXPECT_EQ (body.surface_count, 0u);
    EXPECT_TRUE (body.rectangles.empty());
    EXPECT_FALSE (body.spheres.empty() && body.cylinders.empty());
  }
}

TEST (Street, WindowsOfAHouseAreOnePlaneBehindTheFacade)
{
  Random random (seedOfTest());
  std::set<SurfaceId> facing;
  for (const Rectangle& rectangle : drawTownHouse (12.0, random).rectangles)
    if (std::abs (rectangle.normal().y()) > 0.99)
      facing.insert (rectangle.surface);
  EXPECT_EQ (facing.size(), 3u); // facade, windows, door
}

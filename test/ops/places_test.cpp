// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/places.h"
#include "place_scene.h"

#include <set>

using namespace pcl_ops::internal;

TEST (Places, HaveTheirNearestOthers)
{
  constexpr std::size_t neighbors = 11;
  constexpr std::size_t neighborhood_size = neighbors + 1; // with the place itself
  const PlaceScene scene (drawnOn ({square_of_ground}, 5_cm, 1_mm), neighborhood_size);
  const Places& places = scene.places;
  ASSERT_EQ (places.neighbors_per_place, neighbors);
  ASSERT_EQ (places.size(), scene.distinct.size());
  ASSERT_GT (places.size(), neighbors);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::uint32_t* const nearest = places.nearestOf (i);
    const std::set<std::uint32_t> others (nearest, nearest + neighbors);
    EXPECT_EQ (others.size(), neighbors);
    EXPECT_EQ (others.count (static_cast<std::uint32_t> (i)), 0u);
    std::vector<double> distances; // with the place itself
    for (const Eigen::Vector3d& position : places.position)
      distances.push_back ((position - places.position[i]).norm());
    std::nth_element (
        distances.begin(), distances.begin() + neighbors, distances.end());
    for (const std::uint32_t other : others)
      EXPECT_LE ((places.position[other] - places.position[i]).norm(),
                 distances[neighbors] + 1e-6);
  }
}

TEST (Places, HaveSupportsThatGrow)
{
  const PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 1_mm));
  const Places& places = scene.places;
  ASSERT_GE (places.supports.size(), 3u);
  for (std::size_t level = 1; level < places.supports.size(); ++level) {
    EXPECT_GT (places.points_of_level[level], places.points_of_level[level - 1]);
    double sum_of_widths_below = 0.0; // of the level below
    double sum_of_widths = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      sum_of_widths_below += places.supports[level - 1][i].width;
      sum_of_widths += places.supports[level][i].width;
    }
    // 3.4 times the points make it sqrt (3.4) = 1.8 times as wide, but at rims less.
    EXPECT_GT (sum_of_widths, 1.4 * sum_of_widths_below);
  }
}

TEST (Places, ScatterByTheNoiseAndHaveNormalsOfTheirSurface)
{
  const PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 2_mm));
  double sum_of_scatter = 0.0;
  for (const Support& support : scene.places.supports[1]) {
    sum_of_scatter += support.scatter;
    ASSERT_GT (std::abs (support.normal.z()), 0.95f);
  }
  EXPECT_NEAR (sum_of_scatter / static_cast<double> (scene.places.size()), 2e-3, 2e-4);
}

TEST (Places, OnLevelsScatterByTheVarianceOfTheirStep)
{
  // A slanted wall whose depths z are rounded to steps of 4 cm. Most of the nearest
  // points of a place are on one level, but their true depths may be anywhere within a
  // step.
  Coordinates points = drawnOn ({{{-1, -1, 4.8}, {2, 0, 0.6}, {0, 2, 0.2}}}, 1_cm, 0.0);
  for (float& z : points.z)
    z = static_cast<float> (4_cm * std::round (z / 4_cm));
  const PlaceScene scene (points);
  std::vector<float> scatter;
  for (const Support& support : scene.places.supports[0])
    scatter.push_back (support.scatter);
  // The standard deviation of numbers spread uniformly over an interval is its width
  // over sqrt (12). Along the normal of the slanted wall it is a little less.
  const double deviation_within_step = 4_cm / std::sqrt (12.0);
  EXPECT_GT (medianOf (scatter), 0.9 * deviation_within_step);
}

TEST (Places, OnLevelsHaveNeighborsOnOtherLevels)
{
  // Levels 4 cm apart on a slanted wall are bands 13 cm wide. Points are 1 cm apart, so
  // that the 23 nearest ones reach some 3 cm far: less than from level to level.
  Coordinates points = drawnOn ({{{-1, -1, 4.8}, {2, 0, 0.6}, {0, 2, 0.2}}}, 1_cm, 0.0);
  for (float& z : points.z)
    z = static_cast<float> (4_cm * std::round (z / 4_cm));
  const PlaceScene scene (points);
  std::size_t beside_other_level = 0;
  for (std::size_t i = 0; i < scene.places.size(); ++i) {
    const std::uint32_t* const nearest = scene.places.nearestOf (i);
    beside_other_level += std::any_of (
        nearest, nearest + scene.places.neighbors_per_place, [&] (std::uint32_t other) {
          return std::abs (scene.places.position[other].z() -
                           scene.places.position[i].z()) > 2_cm;
        });
  }
  EXPECT_GT (beside_other_level, scene.places.size() / 5);
}

TEST (Places, OnLevelsScatterAlikeHoweverTheyAreTurned)
{
  // A slanted wall whose depths are rounded to steps of 4 cm, upright and in a frame in
  // which the direction of depth has three different components.
  Eigen::Matrix3d turn;
  turn << 6, 3, 2, -3, 2, 6, 2, -6, 3;
  turn /= 7.0;
  Coordinates upright =
      drawnOn ({{{-1, -1, 4.8}, {2, 0, 0.6}, {0, 2, 0.2}}}, 1_cm, 0.0);
  Coordinates turned;
  for (std::size_t i = 0; i < upright.size(); ++i) {
    upright.z[i] = static_cast<float> (4_cm * std::round (upright.z[i] / 4_cm));
    const pcl::PointXYZ point = toPoint (turn * upright[i]);
    turned.add (point.x, point.y, point.z);
  }
  const auto medianScatterOf = [] (const Coordinates& points) {
    const PlaceScene scene (points);
    std::vector<float> scatter;
    for (const Support& support : scene.places.supports[0])
      scatter.push_back (support.scatter);
    return medianOf (scatter);
  };
  const double scatter = medianScatterOf (upright);
  EXPECT_NEAR (medianScatterOf (turned), scatter, 3_percent * scatter);
}

TEST (Places, AreNotFlatOnALine)
{
  // Points 1 cm apart along x, by turns this far to the left of the line and to its
  // right.
  const auto flatPlaces = [] (float aside) {
    Coordinates points;
    for (int i = 0; i < 400; ++i)
      points.add (0.01f * i, i % 2 == 0 ? aside : -aside, 0.001f * (i % 3));
    const PlaceScene scene (points);
    std::size_t flat = 0;
    for (const Support& support : scene.places.supports[0])
      flat += support.is_flat ? 1 : 0;
    return flat;
  };
  EXPECT_EQ (flatPlaces (0.003f), 0u);
  EXPECT_GT (flatPlaces (0.04f), 350u) << "a strip of 8 cm";
}

TEST (Places, AreAsDenseAsTheirPoints)
{
  const PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 0.0));
  std::vector<float> density (scene.places.density);
  constexpr double expected = 2500.0; // 1 / (2 cm)^2 [1/m^2]
  EXPECT_NEAR (medianOf (density), expected, 1500.0) << "roughly";
}

TEST (NeighborhoodSize, GrowsWithTheNumberOfPointsWithinLimits)
{
  constexpr double usual_factor = 1.0;
  EXPECT_EQ (neighborhoodSize (100, usual_factor), 10u);
  EXPECT_LT (neighborhoodSize (2000, usual_factor),
             neighborhoodSize (20000, usual_factor));
  EXPECT_EQ (neighborhoodSize (10'000'000, usual_factor), 36u);
  EXPECT_EQ (neighborhoodSize (10'000'000, 2.0 * usual_factor), 72u);
}
